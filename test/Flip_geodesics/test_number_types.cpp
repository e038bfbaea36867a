// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Each kind of number goes through all that takes a triangulation: what comes out is what the default gives, or an
// error that the manual names.

#define BOOST_TEST_MODULE number_types

#include "descriptors.h"
#include "generated_meshes.h"
#include "number_type_checks.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/Direction_field.h>
#include <CGAL/Flip_geodesics/Operators.h>
#endif

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Rounded = boost::multiprecision::cpp_bin_float_50;
using Interval = CGAL::Interval_nt<>;

// What a function gives, or why it gives nothing.
using Outcomes = std::map<std::string, double>;
constexpr double insertion_error = -1, undecided = -2, refused = -3;

template <class Traits>
class Functions
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Traits>;
  using Setting = Basic_curve_setting<Triangulation>;
  using Network = typename Setting::Network;
  using Locations = std::vector<FG::Surface_location>;

public:
  explicit Functions(const Mesh_soup& soup)
    : m_soup(soup)
  {
  }

  Outcomes operator()()
  {
    curves();
    points();
    triangulations();
    subdivisions();
    trees();
    functions_on_the_surface();
    return m_outcomes;
  }

private:
  template <class Function>
  void call(const std::string& name, const Function& function)
  {
    Setting s(m_soup);
    try {
      m_outcomes[name] = function(s);
    } catch(const FG::Insertion_error&) {
      m_outcomes[name] = insertion_error;
    } catch(const CGAL::Uncertain_conversion_exception&) {
      m_outcomes[name] = undecided;
    }
  }

  static double pull(Setting& s)
  {
    FG::order_overlapping_curves(s.network);
    s.pull();
    return length(s.network);
  }

  static double length(const Network& network)
  {
    double sum = 0;
    for(int c = 0; c < network.number_of_curves(); ++c)
      sum += network.length(FG::Curve_index(c));
    return sum;
  }

  static FG::Vertex_index last(const Setting& s) { return FG::Vertex_index(s.triangulation.number_of_vertices() - 1); }

  static double pulled_path(Setting& s)
  {
    s.add_path(0_v, last(s));
    return pull(s);
  }

  void curves()
  {
    call("shorten", pulled_path);
    call("add_straightened_path", [](Setting& s) {
      typename Setting::Search search(s.triangulation);
      FG::add_straightened_path(s.network, search(0_v, last(s)));
      return pull(s);
    });
    call("certify", [](Setting& s) {
      pulled_path(s);
      return FG::certify(s.network).is_locally_shortest() ? 1.0 : 0.0;
    });
    call("Straightness_meter", [](Setting& s) {
      pulled_path(s);
      return FG::Straightness_meter<Network>(s.network)(0_c).smallest_angle;
    });
    call("Curve_extractor", [](Setting& s) {
      pulled_path(s);
      std::vector<Surface::Point> points;
      FG::Curve_extractor<Network>(s.network).points(0_c, std::back_inserter(points));
      return static_cast<double>(points.size());
    });
    call("write_network", [](Setting& s) {
      pulled_path(s);
      std::stringstream file;
      FG::write_network(file, s.network);
      s.network.clear();
      s.triangulation.rollback();
      FG::read_network(file, s.network);
      return length(s.network);
    });
    call("add_region_boundaries", [](Setting& s) {
      const auto regions = s.mesh.template add_property_map<Surface::Face_index, int>("f:region", 0).first;
      for(const auto f : s.mesh.faces())
        regions[f] = static_cast<int>(f) < static_cast<int>(s.mesh.number_of_faces() / 2) ? 0 : 1;
      FG::add_region_boundaries(s.network, s.mesh, regions);
      return pull(s);
    });
    call("geodesic_path", [](Setting& s) {
      std::vector<Surface::Point> points;
      return FG::geodesic_path(s.mesh, *s.mesh.vertices().begin(), *--s.mesh.vertices().end(),
                               std::back_inserter(points), CGAL::parameters::geom_traits(Traits()))
          .report.curves[0]
          .length;
    });
    call("add_shortest_path", [](Setting& s) {
      typename Setting::Search search(s.triangulation);
      return FG::add_shortest_path(s.network, search, 0_v, last(s)).length;
    });
  }

  static Locations locations(const Setting& s)
  {
    Random_numbers random(2);
    Locations result;
    for(int i = 0; i < 4; ++i) {
      FG::Input_halfedge_index h;
      do
        h = FG::Input_halfedge_index(random.below(s.triangulation.input().number_of_halfedges()));
      while(s.triangulation.input().is_border(h));
      result.push_back({h, {{1, 2, 1.0 + i}}});
    }
    return result;
  }

  void points()
  {
    call("add_curve_through", [](Setting& s) {
      FG::add_curve_through(s.network, locations(s));
      return pull(s);
    });
    call("add_curve_through after flips", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      FG::add_curve_through(s.network, locations(s));
      return pull(s);
    });
    call("geodesics_through",
         [](Setting& s) { return FG::geodesics_through(s.triangulation, locations(s)).report.curves[0].length; });
    call("draw_polyline", [](Setting& s) {
      FG::draw_polyline(s.network, FG::complete_polyline(s.triangulation, locations(s)));
      return pull(s);
    });
    call("Geodesic_spline", [](Setting& s) {
      FG::Geodesic_spline<Triangulation> spline(s.triangulation, locations(s), FG::Spline_kind::BEZIER);
      spline.refine(0.05, 2);
      spline.finish();
      return spline.length();
    });
    call("add_curve_along", [](Setting& s) {
      FG::add_curve_along(s.network, FG::geodesics_through(s.triangulation, locations(s)).legs);
      return pull(s);
    });
  }

  static FG::Refinement_options options()
  {
    FG::Refinement_options result;
    result.maximum_insertions = 20;
    return result;
  }

  static double outcome(const FG::Refinement_report& report)
  {
    return report.refused > 0 ? refused : static_cast<double>(report.insertions);
  }

  void triangulations()
  {
    call("flip_to_delaunay",
         [](Setting& s) { return static_cast<double>(FG::flip_to_delaunay(s.triangulation).flips); });
    call("refine", [](Setting& s) { return outcome(FG::refine(s.triangulation, options())); });
    call("refine about curves", [](Setting& s) {
      pulled_path(s);
      return outcome(FG::refine(s.network, options()));
    });
    call("shortest_intrinsic_edge_path", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      return static_cast<double>(FG::shortest_intrinsic_edge_path(s.triangulation, 0_v, last(s)).size());
    });
  }

  void subdivisions()
  {
    call("common_subdivision", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      return static_cast<double>(FG::common_subdivision(s.triangulation, s.mesh).mesh().number_of_faces());
    });
    call("insert_curves", [](Setting& s) {
      pulled_path(s);
      return static_cast<double>(FG::insert_curves(s.network, s.mesh).mesh().number_of_faces());
    });
    call("cut_along_curves", [](Setting& s) {
      pulled_path(s);
      return static_cast<double>(FG::cut_along_curves(s.network, s.mesh).mesh().number_of_vertices());
    });
  }

  void trees()
  {
    call("Geodesic_tree", [](Setting& s) {
      FG::Geodesic_tree<Triangulation> tree(s.triangulation);
      tree.grow(0_v);
      return tree.distance(last(s));
    });
    call("logarithmic_map", [](Setting& s) {
      FG::Geodesic_tree<Triangulation> tree(s.triangulation);
      tree.grow(0_v);
      const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);
      return std::prev(map.end())->angle;
    });
    call("make_shortest", [](Setting& s) {
      FG::Geodesic_tree<Triangulation> tree(s.triangulation);
      tree.grow(0_v);
      FG::make_shortest(tree);
      return tree.distance(last(s));
    });
  }

  void functions_on_the_surface()
  {
#ifdef CGAL_EIGEN3_ENABLED
    call("Operators", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      return FG::Operators<Triangulation>(s.triangulation).weak_laplacian().norm();
    });
    call("Direction_field", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      FG::Direction_field<Triangulation> field(s.triangulation);
      field.compute();
      return field.energy();
    });
    call("Conformal_flattening", [](Setting& s) {
      FG::flip_to_delaunay(s.triangulation);
      return FG::Conformal_flattening<Triangulation>(s.network).log_scale(FG::Vertex_copy_index(0));
    });
#endif
  }

  Mesh_soup m_soup;
  Outcomes m_outcomes;
};

// A plane mesh with small angles, where no path is straight by chance, and all areas are rational.
Mesh_soup needles()
{
  return mapped(tieless_plane(6, 1), [](const Coordinates& p) { return Coordinates{4 * p[0], p[1], p[2]}; });
}

using Kernel = CGAL::Simple_cartesian<double>;

const Outcomes& usual_outcomes()
{
  static const Outcomes result = Functions<FG::Intrinsic_triangulation_traits<Kernel>>(needles())();
  return result;
}

template <class Traits>
void check(const Outcomes& exceptions)
{
  const Outcomes found = Functions<Traits>(needles())();
  for(const auto& [name, value] : usual_outcomes()) {
    const auto exception = exceptions.find(name);
    const double expected = exception == exceptions.end() ? value : exception->second;
    BOOST_TEST_CONTEXT(name << " gives " << found.at(name) << " instead of " << expected)
    BOOST_TEST((found.at(name) == expected || std::abs(found.at(name) - expected) < 1e-9 * (1 + std::abs(expected))));
  }
}

// Where edges have been flipped, the coordinates of a point in their frames are no rational numbers.
const Outcomes exceptions_of_exact_numbers = {
    {"add_curve_through after flips", insertion_error}, {"refine", refused}, {"refine about curves", refused}};

} // namespace

BOOST_AUTO_TEST_CASE(doubles_do_everything)
{
  for(const auto& [name, value] : usual_outcomes())
    BOOST_TEST_CONTEXT(name)
  BOOST_TEST(value > insertion_error);
  BOOST_TEST(usual_outcomes().size() > 20u);
}

BOOST_AUTO_TEST_CASE(certified_doubles_do_everything)
{
  check<FG::Certified_intrinsic_triangulation_traits<Kernel>>({});
}

#ifdef FLIP_GEODESICS_TEST_ALL_CASES // as the intervals below, in another arithmetic
BOOST_AUTO_TEST_CASE(rounded_numbers_do_everything) { check<Exact_traits<Rounded>>({}); }
#endif

BOOST_AUTO_TEST_CASE(intervals_do_what_they_decide) { check<Exact_traits<Interval>>({}); }

BOOST_AUTO_TEST_CASE(rational_numbers_have_no_points_after_flips)
{
  check<Exact_traits<Rational>>(exceptions_of_exact_numbers);
}

#ifdef FLIP_GEODESICS_LONG_TESTS
BOOST_AUTO_TEST_CASE(numbers_with_roots_have_no_points_after_flips)
{
  check<Exact_traits<CGAL::Sqrt_extension<Rational, Rational>>>(exceptions_of_exact_numbers);
  check<Exact_traits<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT>>(exceptions_of_exact_numbers);
}
#endif
