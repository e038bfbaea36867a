// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What each number type costs: the same paths, pulled tight by every kind of traits in turn, on generated meshes.
// Writes CSV, a row for each mesh and number type.
//
//   number_types [SIZE [ROUNDS]]
//
// `first_ms` is the first round, in which the input's faces are laid out; `median_ms` the median of the others. Both
// are processor time of shorten() alone. A path that throws, because an interval is undecided, or that takes longer
// than its time, is not counted among the `done`. A number type that a mesh does not suit has no row; nor have
// expressions with large meshes or where ties meet many roots, as the time of a zero is exponential in the number of
// its roots.

#include "../../test/Flip_geodesics/generated_meshes.h"
#include "../../test/Flip_geodesics/random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Uncertain.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Chain = std::vector<FG::Halfedge_index>;
using Gmpq = CGAL::Gmpq;
using Rational = boost::multiprecision::cpp_rational;
using Extension = CGAL::Sqrt_extension<Gmpq, Gmpq>;
using Expression = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Stops a path that takes too long.
class Time_limit_visitor : public FG::Default_shortening_visitor
{
public:
  explicit Time_limit_visitor(double limit)
    : m_end(seconds() + limit)
  {
  }

  bool go_further() { return seconds() < m_end; }

private:
  double m_end;
};

struct Measurement
{
  std::vector<double> times; // of a round each
  std::size_t flips = 0;
  int done = 0, certified = 0;
};

/// Pulls all paths tight once.
class Contestant
{
public:
  virtual ~Contestant() = default;
  virtual void run(const std::vector<Chain>& paths, Measurement& measurement) = 0;
};

template <class Traits>
class Traits_contestant : public Contestant
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;

public:
  Traits_contestant(const Mesh& mesh, const Traits& traits)
    : m_triangulation(mesh, traits)
  {
  }

  void run(const std::vector<Chain>& paths, Measurement& measurement) override
  {
    measurement.flips = 0;
    measurement.done = measurement.certified = 0;
    double time = 0;
    for(const Chain& path : paths)
      run(path, measurement, time);
    measurement.times.push_back(time);
  }

private:
  void run(const Chain& path, Measurement& measurement, double& time)
  {
    constexpr double limit = 5;
    FG::Edge_path_network<Triangulation> network(m_triangulation);
    network.add_curve(path);
    const double start = seconds();
    try {
      const FG::Shortening_report report = FG::shorten(network, CGAL::parameters::visitor(Time_limit_visitor(limit)));
      time += seconds() - start;
      measurement.flips += report.flips;
      measurement.done += report.is_complete() ? 1 : 0;
      measurement.certified += FG::certify(network).is_locally_shortest() ? 1 : 0;
    } catch(const CGAL::Uncertain_conversion_exception&) {
      time += seconds() - start;
    }
    network.clear();
    m_triangulation.rollback();
  }

  Triangulation m_triangulation;
};

template <class Traits>
std::unique_ptr<Contestant> contestant(const Mesh& mesh, const Traits& traits = Traits())
{
  return std::make_unique<Traits_contestant<Traits>>(mesh, traits);
}

template <class NT>
std::unique_ptr<Contestant> exact_contestant(const Mesh& mesh)
{
  return contestant<FG::Exact_intrinsic_triangulation_traits<NT>>(mesh);
}

template <class NT>
std::unique_ptr<Contestant> contestant_with_radicand(const Mesh& mesh)
{
  using Traits = FG::Exact_intrinsic_triangulation_traits<NT>;
  return contestant(mesh, Traits(FG::common_radicand<typename Traits::Radicand>(mesh)));
}

using Entry = std::pair<std::string, std::function<std::unique_ptr<Contestant>(const Mesh&)>>;

const std::string expressions = "EPECK_with_sqrt::FT";

const std::vector<Entry>& entries()
{
  using Plain = FG::Intrinsic_triangulation_traits<Kernel>;
  using Certified = FG::Certified_intrinsic_triangulation_traits<Kernel>;
  static const std::vector<Entry> result = {
      {"plain", [](const Mesh& mesh) { return contestant<Plain>(mesh); }},
      {"certified", [](const Mesh& mesh) { return contestant<Certified>(mesh); }},
      {"double", exact_contestant<double>},
      {"Interval_nt", exact_contestant<CGAL::Interval_nt<>>},
      {"cpp_bin_float_100", exact_contestant<boost::multiprecision::cpp_bin_float_100>},
      {"mpfr_float_100", exact_contestant<boost::multiprecision::mpfr_float_100>},
      {"Gmpq", contestant_with_radicand<Gmpq>},
      {"cpp_rational", contestant_with_radicand<Rational>},
      {"Sqrt_extension<Gmpq>", contestant_with_radicand<Extension>},
      {expressions, exact_contestant<Expression>}};
  return result;
}

std::vector<Chain> random_paths(const Mesh& mesh, int count)
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh>;
  const Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Random_numbers random(1);
  std::vector<Chain> paths;
  while(static_cast<int>(paths.size()) < count) {
    const FG::Vertex_index u(random.below(triangulation.number_of_vertices())),
        v(random.below(triangulation.number_of_vertices()));
    if(u != v)
      paths.push_back(search(u, v));
  }
  return paths;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void measure(const std::string& name, const Mesh_soup& soup, int rounds, bool has_expressions = true)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  const std::vector<Chain> paths = random_paths(mesh, 20);
  std::vector<std::pair<std::string, std::unique_ptr<Contestant>>> contestants;
  for(const auto& [number_type, make] : entries())
    try {
      if(has_expressions || number_type != expressions)
        contestants.emplace_back(number_type, make(mesh));
    } catch(const FG::Inexact_root_error&) {
      std::cerr << number_type << " does not suit " << name << '\n';
    }

  std::map<std::string, Measurement> measurements;
  for(int round = 0; round <= rounds; ++round)
    for(const auto& [number_type, contestant] : contestants) {
      Measurement& m = measurements[number_type];
      const bool is_slow = !m.times.empty() && m.times.front() > 5; // one further round will do
      if(!is_slow || m.times.size() < 2)
        contestant->run(paths, m);
    }

  const double plain = median({measurements["plain"].times.begin() + 1, measurements["plain"].times.end()});
  for(const auto& [number_type, contestant] : contestants) {
    const Measurement& m = measurements[number_type];
    const double time = median({m.times.begin() + 1, m.times.end()});
    std::cout << name << ',' << number_type << ',' << paths.size() << ',' << m.done << ',' << m.certified << ','
              << m.flips << ',' << m.times.front() * 1e3 << ',' << time * 1e3 << ',' << time / plain << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 12, rounds = argc > 2 ? std::atoi(argv[2]) : 9;
  if(n < 4 || rounds < 1) {
    std::cerr << "usage: number_types [SIZE [ROUNDS]], SIZE at least 4\n";
    return 2;
  }
  std::cout << "mesh,number_type,paths,done,certified,flips,first_ms,median_ms,ratio_to_plain\n";
  std::cout.precision(4);
  const bool is_small = n <= 12;
  measure("grid", flat_grid(n, n, Diagonal_rule::RANDOM), rounds, is_small);
  measure("jittered plane", jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 1), rounds, is_small);
  measure("cube", cube(n / 2), rounds, is_small);
  measure("small tetrahedron", tetrahedron(4), rounds);
  measure("tetrahedron", tetrahedron(n), rounds, false);
  measure("bumpy sphere", bumpy_sphere(n / 2, 0.05, 1), rounds, is_small);
  return std::cout.flush() ? 0 : 1;
}
