// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the same path with ten kernels, each with two kinds of predicates: the exact predicates that are the
// default, and predicates that are evaluated in the number type of the kernel. The mesh is a folded sheet with cells of
// 1/3 by 1/7, numbers that are not representable as doubles.
//
//   kernels_example

#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Uncertain.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> folded_sheet()
{
  using FT = typename Kernel::FT;
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
  const auto point = [](std::size_t i, std::size_t j) {
    const int x = static_cast<int>(i), y = static_cast<int>(j), fold = 2;
    const FT third = FT(1) / FT(3), seventh = FT(1) / FT(7);
    return
        typename Kernel::Point_3(FT((std::min)(x, fold)) * third, FT(y) * seventh, FT((std::max)(x - fold, 0)) * third);
  };
  CGAL::make_grid(3, 3, mesh, point, true);
  return mesh;
}

// Passes `traits`, which is a kernel or a traits class over it, as `geom_traits()`.
template <class Kernel, class Traits>
void print_path(const std::string& kernel, const std::string& predicates, const Traits& traits)
{
  const auto mesh = folded_sheet<Kernel>();
  const auto ends = mesh.vertices();
  std::vector<typename Kernel::Point_3> points;
  std::cout << std::left << std::setw(18) << kernel << std::setw(13) << predicates;
  CGAL::Real_timer timer;
  timer.start();
  try {
    const auto path = FG::geodesic_path(mesh, *std::next(ends.begin(), 3), *std::prev(ends.end(), 4),
                                        std::back_inserter(points), CGAL::parameters::geom_traits(traits));
    std::cout << std::setw(11) << to_string(path.verdict()) << path.length();
  } catch(const CGAL::Uncertain_conversion_exception&) {
    std::cout << std::setw(11) << "-"
              << "intervals do not determine a sign";
  }
  std::cout << "   " << static_cast<int>(timer.time() * 1e6) << " microseconds\n";
}

// The arguments describe the predicates: those that are the default, and those in the number type of the kernel.
template <class Kernel>
void print_both(const std::string& kernel, const std::string& by_default, const std::string& of_numbers)
{
  print_path<Kernel>(kernel, by_default, Kernel());
  print_path<Kernel>("", of_numbers, FG::Intrinsic_triangulation_traits<Kernel>());
}

int main()
try {
  using Rational = boost::multiprecision::cpp_rational;
  using With_sqrt = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
  std::cout << std::setprecision(17);
  print_both<CGAL::Simple_cartesian<float>>("float", "exact", "rounded");
  print_both<CGAL::Simple_cartesian<double>>("double", "exact", "rounded");
  print_both<CGAL::Simple_cartesian<long double>>("long double", "of doubles", "rounded");
  print_both<CGAL::Simple_cartesian<CGAL::Interval_nt<>>>("Interval_nt", "of doubles", "exact or -");
  print_both<CGAL::Exact_predicates_inexact_constructions_kernel>("EPICK", "exact", "rounded");
  print_both<CGAL::Exact_predicates_exact_constructions_kernel>("EPECK", "exact", "exact");
  print_both<With_sqrt>("EPECK_with_sqrt", "of doubles", "exact");
  print_both<CGAL::Simple_cartesian<CGAL::Gmpq>>("Gmpq", "exact", "exact");
  print_both<CGAL::Simple_cartesian<Rational>>("cpp_rational", "exact", "exact");
  print_both<CGAL::Simple_cartesian<CORE::Expr>>("CORE::Expr", "of doubles", "exact");
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
