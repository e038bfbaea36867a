// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The flips of certified traits are a function of the input alone. Here are the words of crossed edges and the flipped
// halfedges of paths and networks on small meshes, and the words of the shortest paths of a tree: as hashes that a build
// for any processor, with any options, has to meet. Needs nothing but headers. Prints what it has computed where that is
// something else; that is what to record if a change is meant.

#include "Integer_hash.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/arithmetic/Double_double.h>
#include <CGAL/Flip_geodesics/internal/exact/Integer.h>
#include <CGAL/Flip_geodesics/make_shortest.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Kernel>>;
using Network = FG::Edge_path_network<Triangulation>;

struct Input
{
  std::string name;
  Mesh_soup soup;
  std::string recorded, recorded_of_shortest;
};

// Full of ties, and without any.
std::vector<Input> inputs()
{
  return {
      {"flat_grid", flat_grid(14, 12, Diagonal_rule::ALTERNATING), "94a3d778e7ef2bc3", "25cba5506cb76d8a"},
      {"jittered_grid", jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5), "ef946ce9d18c772a", "a32da75944ca5d38"},
      {"hills", grid(16, 16, Diagonal_rule::RANDOM, [](int i, int j) { return ((i * 7 + j * 13) % 5) * 0.4; }),
       "fe44b3187743b97e", "2119e28d6a6324ac"},
      {"cube", cube(6), "f795f19c82811412", "91cca59809b86b03"},
      {"plate", genus_3_plate(2), "d408724a28722213", "a551e310915909d3"},
      {"pointed_cone", cone_disk(9, 9, 2), "191791031ba2b03b", "8a82698a7f1b6eb6"},
      {"saddle", saddle_disk(12, 8, 9), "5b997baf6ed386fc", "bd5f348f01c1fe47"},
      {"lantern", lantern(10, 40), "3a9f024bedb6d136", "57d90174b880bdc9"},
      {"torus", torus(26, 14, 3, 1), "f1587442fc2cdafa", "cf657860470452fc"},
      {"sphere", sphere(9), "ce715cdfcd137786", "b154d42343fa8902"},
      {"bumpy_sphere", bumpy_sphere(8, 0.3, 1), "b6225accb16e3c20", "36168c97958c6ede"},
      {"shaken_plate", shaken(genus_3_plate(2), 0.3, 4), "b9249145821f7602", "02987b86c4654cc0"}};
}

class Recorder
{
public:
  explicit Recorder(const Mesh_soup& soup)
    : m_mesh(to_mesh<Surface>(soup))
    , m_triangulation(m_mesh)
    , m_random(static_cast<unsigned>(soup.triangles.size()))
  {
  }

  std::string text()
  {
    FG::Shortest_edge_path<Triangulation> look_back(m_triangulation, FG::Search_method::LOOK_BACK);
    for(int i = 0; i < 40; ++i)
      add([&](Network& network) {
        const FG::Vertex_index source = random_vertex();
        FG::add_straightened_path(network, look_back(source, other_vertex(source)));
      });
    FG::Shortest_edge_path<Triangulation> dijkstra(m_triangulation, FG::Search_method::DIJKSTRA);
    for(int i = 0; i < 8; ++i)
      add([&](Network& network) {
        const FG::Vertex_index source = random_vertex();
        for(int j = 0; j < 5; ++j)
          network.add_curve(dijkstra(source, other_vertex(source)), false);
        FG::order_overlapping_curves(network);
      });
    return m_hash.text();
  }

  // Of a tree, after `make_shortest()`.
  std::string text_of_shortest_paths()
  {
    m_hash = Integer_hash();
    FG::Geodesic_tree<Triangulation> tree(m_triangulation);
    m_hash.add(static_cast<long long>(tree.grow(random_vertex()).status));
    const FG::Shortest_tree_report report = FG::make_shortest(tree);
    m_hash.add(static_cast<long long>(report.status));
    for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(number_of_vertices())) {
      for(const auto h : tree.path(v)) {
        const FG::Crossing_word word = m_triangulation.crossing_word(h);
        m_hash.add(word.along);
        m_hash.add_all(word.crossed);
      }
    }
    m_triangulation.rollback();
    return m_hash.text();
  }

private:
  int number_of_vertices() const { return m_triangulation.input().number_of_vertices(); }
  FG::Vertex_index random_vertex() { return FG::Vertex_index(m_random.below(number_of_vertices())); }
  FG::Vertex_index other_vertex(FG::Vertex_index v)
  {
    return FG::Vertex_index((v.idx() + 1 + m_random.below(number_of_vertices() - 1)) % number_of_vertices());
  }

  template <class AddCurves>
  void add(const AddCurves& add_curves)
  {
    Network network(m_triangulation);
    add_curves(network);
    for(const FG::Curve_report& curve : FG::shorten(network).curves)
      m_hash.add(static_cast<long long>(curve.status));
    for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(network.number_of_curves()))
      for(const auto h : network.halfedges(c)) {
        const FG::Crossing_word word = m_triangulation.crossing_word(h);
        m_hash.add(word.along);
        m_hash.add_all(word.crossed);
      }
    for(std::size_t i = 0; i < m_triangulation.log_position(); ++i)
      m_hash.add(m_triangulation.flip_record(i).h);
    network.clear();
    m_triangulation.rollback();
  }

  Surface m_mesh;
  Triangulation m_triangulation;
  Random_numbers m_random;
  Integer_hash m_hash;
};

bool are_words_recorded()
{
  bool result = true;
  for(const Input& input : inputs()) {
    std::string text, of_shortest;
    try {
      Recorder recorder(with_rounded_coordinates(input.soup));
      text = recorder.text();
      of_shortest = recorder.text_of_shortest_paths();
    } catch(const std::exception& error) {
      text = error.what();
    }
    if(text == input.recorded && of_shortest == input.recorded_of_shortest)
      continue;
    std::cerr << input.name << ": recorded " << input.recorded << ", " << input.recorded_of_shortest << ", now " << text
              << ", " << of_shortest << "\n";
    result = false;
  }
  return result;
}

// Is nothing fused that has to be rounded, also where the terms are products?
bool are_sums_and_products_exact()
{
  namespace internal = FG::internal;
  using internal::Integer;
  const auto exactly = [](const internal::Double_double& x) { return Integer(Integer(x.high) + Integer(x.low)); };
  Random_numbers random(7);
  const auto integer = [&] { return std::nearbyint(random.uniform(-1e15, 1e15)); };
  for(int i = 0; i < 10000; ++i) {
    const double a = integer(), b = integer(), c = integer(), d = integer();
    volatile double first = a, third = c; // so that these products are not those below
    volatile double ab = first * b, cd = third * d;
    const Integer sum = Integer(ab) + Integer(cd), product = Integer(a) * Integer(b);
    if(exactly(internal::exact_sum(a * b, c * d)) != sum || exactly(internal::exact_product(a, b)) != product) {
      std::cerr << "a sum or a product is not exact\n";
      return false;
    }
  }
  return true;
}

} // namespace

int main()
{
  const bool is_exact = are_sums_and_products_exact();
  return are_words_recorded() && is_exact ? 0 : 1;
}
