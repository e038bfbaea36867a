// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The flips of certified traits are a function of the input alone. Here are the words of crossed edges and the flipped
// halfedges of paths and networks on small meshes, the words of the shortest paths of a tree, and a distance field: as
// hashes that a build for any processor, with any options, has to meet. Needs nothing but headers. Prints what it has
// computed where that is something else; that is what to record if a change is meant.

#include "Integer_hash.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
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
  bool has_ties;
  Mesh_soup soup;
  std::string recorded, recorded_of_shortest, recorded_of_field;
};

// Full of ties, and without any.
std::vector<Input> inputs()
{
  return {{"flat_grid", true, flat_grid(14, 12, Diagonal_rule::ALTERNATING), "aa3986adcacbb086", "25cba5506cb76d8a",
           "4952b301c6771fa4"},
          {"jittered_grid", false, jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5), "2ba594886e6aa07b",
           "a32da75944ca5d38", "2d63d47443bf76ed"},
          {"hills", true,
           grid(16, 16, Diagonal_rule::RANDOM, [](int i, int j) { return ((i * 7 + j * 13) % 5) * 0.4; }),
           "569624ae7b2f9fcd", "2119e28d6a6324ac", "1297aea9bd86eac8"},
          {"cube", true, cube(6), "548b06880aee91b6", "91cca59809b86b03", "932283f4e0415b84"},
          {"plate", true, genus_3_plate(2), "3db7fc98846aabc9", "a551e310915909d3", "985af5f4bbc8bb95"},
          {"pointed_cone", true, cone_disk(9, 9, 2), "1d4f53beffdb1a54", "8a82698a7f1b6eb6", "5618ea11efd49722"},
          {"saddle", true, saddle_disk(12, 8, 9), "b4cf8257fb640964", "bd5f348f01c1fe47", "b9078930c749b3e4"},
          {"lantern", true, lantern(10, 40), "b54740aa8b7061a3", "57d90174b880bdc9", "1f19fa4718e15cee"},
          {"torus", true, torus(26, 14, 3, 1), "e070db1322e72e89", "cf657860470452fc", "f4de14468cb0e1d3"},
          {"sphere", true, sphere(9), "a3a2608f944c5d48", "b154d42343fa8902", "74767e57bd78392b"},
          {"bumpy_sphere", false, bumpy_sphere(8, 0.3, 1), "3c4a5e3e1e308fdb", "36168c97958c6ede", "9da014654cdcf7ea"},
          {"shaken_plate", false, shaken(genus_3_plate(2), 0.3, 4), "9a15a0d37a8b5d12", "02987b86c4654cc0",
           "5c623e231bf96b6e"}};
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
    FG::Shortest_edge_path<Triangulation> look_back(m_triangulation,
                                                    CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    for(int i = 0; i < 40; ++i)
      add([&](Network& network) {
        const FG::Vertex_index source = random_vertex();
        FG::add_straightened_path(network, look_back(source, other_vertex(source)));
      });
    FG::Shortest_edge_path<Triangulation> dijkstra(m_triangulation,
                                                   CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
    for(int i = 0; i < 8; ++i)
      add([&](Network& network) {
        const FG::Vertex_index source = random_vertex();
        for(int j = 0; j < 5; ++j)
          network.add_curve(dijkstra(source, other_vertex(source)));
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
    const FG::Distances_report report = FG::make_shortest(tree);
    m_hash.add(static_cast<long long>(report.status));
    for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(number_of_vertices())) {
      for(const auto h : tree.path(v)) {
        const FG::Edge_sequence word = m_triangulation.edge_sequence(h);
        m_hash.add(word.along);
        m_hash.add_all(word.crossed);
      }
    }
    m_triangulation.rollback();
    return m_hash.text();
  }

  // Of three sources: how far the nearest is from each vertex, but for last bits; and where there are no ties, which
  // one that is, and where the path crosses edges and bends.
  std::string text_of_field(bool has_ties)
  {
    m_hash = Integer_hash();
    FG::Geodesic_distance_field<Triangulation> field(m_triangulation, m_mesh);
    for(int i = 0; i < 3; ++i)
      field.add_source(random_vertex());
    m_hash.add(static_cast<long long>(field.compute().status));
    for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(number_of_vertices())) {
      m_hash.add(std::llround(field.distance(v) * 0x1p30));
      if(has_ties)
        continue;
      m_hash.add(static_cast<long long>(field.answer(v).source));
      for(const FG::Surface_point& p : field.surface_points(m_triangulation.location(v)))
        m_hash.add(p.is_vertex() ? p.a.idx() : p.halfedge.idx());
    }
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
        const FG::Edge_sequence word = m_triangulation.edge_sequence(h);
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
    std::string text, of_shortest, of_field;
    try {
      Recorder recorder(with_rounded_coordinates(input.soup));
      text = recorder.text();
      of_shortest = recorder.text_of_shortest_paths();
      of_field = recorder.text_of_field(input.has_ties);
    } catch(const std::exception& error) {
      text = error.what();
    }
    if(text == input.recorded && of_shortest == input.recorded_of_shortest && of_field == input.recorded_of_field)
      continue;
    std::cerr << input.name << ": recorded " << input.recorded << ", " << input.recorded_of_shortest << ", "
              << input.recorded_of_field << ", now " << text << ", " << of_shortest << ", " << of_field << "\n";
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
