// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The table of kernels in the manual: what predicates and verdicts are over each, by default and in its number type.

#include "test_kernels/exact_coordinates.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Verdict;

namespace {

struct Flip_recorder : FG::Default_shortening_visitor
{
  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index h)
  {
    flips.push_back(h.idx());
  }

  std::vector<int> flips;
};

// What came out of the paths on a mesh, and whether intervals left a sign open.
struct Paths
{
  std::vector<Verdict> verdicts;
  std::vector<double> lengths;
  std::vector<int> flips;
  std::size_t points = 0;
  bool is_undecided = false;
};

template <class Kernel, class Traits>
Paths paths(const CGAL::Surface_mesh<typename Kernel::Point_3>& mesh, const Traits& traits)
{
  using Vertex = typename CGAL::Surface_mesh<typename Kernel::Point_3>::Vertex_index;
  const auto n = static_cast<unsigned>(mesh.number_of_vertices());
  Paths result;
  Flip_recorder recorder;
  std::vector<typename Kernel::Point_3> points;
  for(unsigned v = 0; v < n; v += 5)
    try {
      const auto path = FG::geodesic_path(mesh, Vertex(v), Vertex((3 * v + n / 2) % n), std::back_inserter(points),
                                          CGAL::parameters::geom_traits(traits).visitor(std::ref(recorder)));
      BOOST_TEST(path.report.is_complete());
      BOOST_TEST((path.report.curves.front().status == FG::Shortening_status::LOCALLY_SHORTEST));
      result.verdicts.push_back(path.verdict());
      result.lengths.push_back(path.length());
    } catch(const CGAL::Uncertain_conversion_exception&) {
      result.is_undecided = true;
    }
  result.flips = recorder.flips;
  result.points = points.size();
  return result;
}

enum class Numbers { EXACT, ROUNDED, INTERVALS };

// A row of the table.
struct Promise
{
  bool reads_exactly; // any coordinates, not only those that are doubles
  Numbers numbers;
  double precision; // of lengths
};

// Full of angles that are exactly straight.
const Lattice_surface& box()
{
  static const Lattice_surface result = lattice_box({3, 2, 1});
  return result;
}

template <class Kernel>
typename Kernel::Point_3 in_the_lattice(const Lattice_point& p)
{
  using FT = typename Kernel::FT;
  return {FT(p[0] / 4.0), FT(p[1] / 4.0), FT(p[2] / 4.0)};
}

using Reference = CGAL::Simple_cartesian<double>;

// The coordinates in odd cells times 231, which are integers.
Reference::Point_3 in_scaled_cells(const Lattice_point& p) { return {p[0] * 77.0, p[1] * 33.0, p[2] * 21.0}; }

void check_lengths(const Paths& found, const Paths& expected, double unit, double precision)
{
  BOOST_TEST_REQUIRE(found.lengths.size() == expected.lengths.size());
  for(std::size_t i = 0; i < found.lengths.size(); ++i)
    BOOST_TEST(std::abs(found.lengths[i] * unit - expected.lengths[i]) <= precision * expected.lengths[i]);
}

void check_verdicts(const Paths& found, bool is_proven)
{
  for(const Verdict verdict : found.verdicts)
    BOOST_TEST((verdict == (is_proven ? Verdict::PROVEN : Verdict::UNDECIDED)));
}

template <class Kernel>
class Row
{
public:
  explicit Row(const Promise& promise)
    : m_promise(promise)
  {
    const Paths of_lattice = paths<Reference>(mesh_of<Reference>(box(), in_the_lattice<Reference>), Reference());
    const Paths of_cells = paths<Reference>(mesh_of<Reference>(box(), in_scaled_cells), Reference());
    check_default(mesh_of<Kernel>(box(), in_the_lattice<Kernel>), of_lattice, 1, true);
    check_default(mesh_of<Kernel>(box(), in_odd_cells<Kernel>), of_cells, 231, promise.reads_exactly);
    check_numbers(mesh_of<Kernel>(box(), in_the_lattice<Kernel>), of_lattice, 1);
    check_numbers(mesh_of<Kernel>(box(), in_odd_cells<Kernel>), of_cells, 231);
  }

private:
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

  // Proven, with the flips of the reference, if the coordinates are what they are read as.
  void check_default(const Mesh& mesh, const Paths& expected, double unit, bool is_read_exactly) const
  {
    const bool is_rounded = unit != 1 && std::is_floating_point<typename Kernel::FT>::value;
    const Paths found = paths<Kernel>(mesh, Kernel());
    check_verdicts(found, is_read_exactly);
    check_lengths(found, expected, unit, m_promise.precision);
    if(is_read_exactly && !is_rounded)
      BOOST_TEST(found.flips == expected.flips, boost::test_tools::per_element());
    if(is_read_exactly && !is_rounded)
      BOOST_TEST(found.points == expected.points);
  }

  void check_numbers(const Mesh& mesh, const Paths& expected, double unit) const
  {
    const Paths found = paths<Kernel>(mesh, FG::Intrinsic_triangulation_traits<Kernel>());
    BOOST_TEST(found.is_undecided == (m_promise.numbers == Numbers::INTERVALS && unit != 1));
    if(found.is_undecided)
      return;
    check_lengths(found, expected, unit, m_promise.precision);
    BOOST_TEST(found.points == expected.points);
    const bool is_exact = m_promise.numbers != Numbers::ROUNDED;
    check_verdicts(found, is_exact && (unit == 1 || m_promise.reads_exactly));
    if(is_exact)
      BOOST_TEST(found.flips == expected.flips, boost::test_tools::per_element());
  }

  Promise m_promise;
};

constexpr double of_doubles = 1e-14, of_floats = 1e-5;

} // namespace

BOOST_AUTO_TEST_CASE(kernels_of_rounded_numbers)
{
  Row<CGAL::Simple_cartesian<float>>({true, Numbers::ROUNDED, of_floats});
  Row<CGAL::Simple_cartesian<double>>({true, Numbers::ROUNDED, of_doubles});
  Row<CGAL::Simple_cartesian<long double>>({false, Numbers::ROUNDED, of_doubles});
  Row<CGAL::Simple_cartesian<CGAL::Interval_nt<>>>({false, Numbers::INTERVALS, of_doubles});
  Row<CGAL::Exact_predicates_inexact_constructions_kernel>({true, Numbers::ROUNDED, of_doubles});
}

BOOST_AUTO_TEST_CASE(kernels_of_rational_numbers)
{
  Row<CGAL::Exact_predicates_exact_constructions_kernel>({true, Numbers::EXACT, of_doubles});
  Row<CGAL::Simple_cartesian<CGAL::Gmpq>>({true, Numbers::EXACT, of_doubles});
  Row<CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>>({true, Numbers::EXACT, of_doubles});
}

BOOST_AUTO_TEST_CASE(kernels_of_numbers_with_roots)
{
  Row<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>({false, Numbers::EXACT, of_doubles});
  Row<CGAL::Simple_cartesian<CORE::Expr>>({false, Numbers::EXACT, of_doubles});
}

// Squared lengths are of the number type: 2/9 is none of the doubles, and long doubles have more digits.
template <class Kernel>
typename FG::Intrinsic_triangulation_traits<Kernel>::FT squared_diagonal()
{
  using FT = typename Kernel::FT;
  const auto mesh = mesh_of<Kernel>(lattice_grid(1), [](const Lattice_point& p) {
    return typename Kernel::Point_3(FT(p[0]) / FT(3), FT(p[1]) / FT(3), FT(0));
  });
  using Mesh = std::decay_t<decltype(mesh)>;
  FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>> triangulation(mesh);
  const auto diagonal = mesh.halfedge(typename Mesh::Vertex_index(0), typename Mesh::Vertex_index(3));
  static_assert(std::is_same<typename decltype(triangulation)::Traits::FT, FT>::value);
  return triangulation.squared_length(triangulation.index(diagonal));
}

BOOST_AUTO_TEST_CASE(squared_lengths_in_the_number_type)
{
  using Rational = boost::multiprecision::cpp_rational;
  using Lazy = CGAL::Exact_predicates_exact_constructions_kernel;
  BOOST_TEST((squared_diagonal<CGAL::Simple_cartesian<CGAL::Gmpq>>() == CGAL::Gmpq(2, 9)));
  BOOST_TEST((squared_diagonal<CGAL::Simple_cartesian<Rational>>() == Rational(2, 9)));
  BOOST_TEST((squared_diagonal<Lazy>() == Lazy::FT(2) / Lazy::FT(9)));
  BOOST_TEST((squared_diagonal<CGAL::Simple_cartesian<CORE::Expr>>() == CORE::Expr(2) / CORE::Expr(9)));
  const auto error = [](auto x) { return std::abs(static_cast<double>(x - 2 / 9.0L)); };
  BOOST_TEST(error(squared_diagonal<CGAL::Simple_cartesian<float>>()) > 1e-10);
  BOOST_TEST(error(squared_diagonal<CGAL::Simple_cartesian<double>>()) > 1e-18);
  BOOST_TEST(error(squared_diagonal<CGAL::Simple_cartesian<long double>>()) < 1e-18);
  using Interval = CGAL::Interval_nt<>;
  const Interval interval = squared_diagonal<CGAL::Simple_cartesian<Interval>>();
  BOOST_TEST((interval.inf() < 2 / 9.0L && 2 / 9.0L < interval.sup()));
}
