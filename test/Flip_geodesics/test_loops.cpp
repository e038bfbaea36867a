// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Loops found from the surface alone: how many there are, how long, what class any closed curve has in them, and that
// classes stay what they are when curves are pulled tight.

#define BOOST_TEST_MODULE loops

#include "test_loops/loop_setting.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

// A curve of the same homotopy class as before, with its first vertex held, by so many random moves over faces.
Input_chain wandered(const Setting& s, Input_chain chain, FG::Vertex_index start, int moves, Random_numbers& random)
{
  const auto& input = s.triangulation.input();
  for(int i = 0; i < moves; ++i) {
    const auto position = chain.begin() + random.below(static_cast<int>(chain.size()) + 1);
    if(position == chain.end() || random.below(3) == 0) { // out and back along an edge
      FG::Input_halfedge_index h =
          input.outgoing(position == chain.end() ? (chain.empty() ? start : input.tail(input.twin(chain.back())))
                                                 : input.tail(*position));
      for(int turns = random.below(6); turns > 0; --turns)
        h = input.next(input.twin(h));
      chain.insert(position, {h, input.twin(h)});
    } else if(!input.is_border(*position)) { // over the face to the left
      const FG::Input_halfedge_index h = *position;
      *position = input.twin(input.next(h));
      chain.insert(position, input.twin(input.previous(h)));
    }
    for(std::size_t k = 0; k + 1 < chain.size();)
      if(chain[k + 1] == input.twin(chain[k])) {
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(k), chain.begin() + static_cast<std::ptrdiff_t>(k) + 2);
        k = k == 0 ? 0 : k - 1;
      } else {
        ++k;
      }
    if(chain.empty())
      start =
          random.below(2) == 0 ? start : FG::Vertex_index(random.below(static_cast<int>(input.number_of_vertices())));
  }
  return chain;
}

Input_chain commutator(const Input_chain& a, const Input_chain& b)
{
  Input_chain result = a;
  result.insert(result.end(), b.begin(), b.end());
  for(const Input_chain& c : {a, b})
    for(std::size_t i = c.size(); i-- > 0;)
      result.push_back(FG::internal::twin_index(c[i]));
  return result;
}

void check_basis(const Setting& s, FG::Index genus, FG::Index borders)
{
  BOOST_TEST_REQUIRE(s.basis.components().size() == 1u);
  const auto& component = s.basis.components().front();
  BOOST_TEST(component.genus == genus);
  BOOST_TEST(component.number_of_borders == borders);
  BOOST_TEST(component.number_of_loops == 2 * genus + (borders > 0 ? borders - 1 : 0));
  BOOST_TEST(s.basis.number_of_loops() == component.number_of_loops);
  for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i) {
    const Chain loop = s.basis.loop(i), cycle = s.basis.cycle(i);
    BOOST_TEST(s.triangulation.tail(loop.front()) == component.base_point);
    BOOST_TEST(std::abs(s.length(loop) - s.basis.length(i)) < 1e-12 * s.basis.length(i));
    BOOST_TEST(cycle.size() <= loop.size());
    std::set<FG::Vertex_index> passed;
    for(FG::Halfedge_index h : cycle)
      BOOST_TEST(passed.insert(s.triangulation.tail(h)).second);
    BOOST_TEST((i == 0 || s.basis.length(i - 1) <= s.basis.length(i)));
    BOOST_TEST(s.basis.homology_class(Setting::input_chain(loop)) == s.unit(i));
    BOOST_TEST(s.basis.homology_class(Setting::input_chain(cycle)) == s.unit(i));
    BOOST_TEST(!s.basis.is_contractible(Setting::input_chain(cycle)));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(basis_of_generated_surfaces)
{
  check_basis(Setting(torus(9, 7, 3, 1)), 1, 0);
  check_basis(Setting(torus(9, 7, 3, 1), {40_v}), 1, 0);
  for(int genus : {2, 3, 20}) {
    check_basis(Setting(plate(genus)), genus, 0);
    check_basis(Setting(punctured(plate(genus, 2), 1)), genus, 1);
    check_basis(Setting(punctured(plate(genus, 2), 5)), genus, 5);
  }
  check_basis(Setting(grid_with_hole(5, 5, 2, 3, 2, 3)), 0, 2);
  check_basis(Setting(cylinder(6, 4, 1, 3)), 0, 2);
}

BOOST_AUTO_TEST_CASE(no_loops_where_there_are_none)
{
  check_basis(Setting(tetrahedron()), 0, 0);
  check_basis(Setting(sphere(3)), 0, 0);
  check_basis(Setting(single_triangle()), 0, 1);
  check_basis(Setting(flat_grid(4, 3, Diagonal_rule::ALTERNATING)), 0, 1);
  const Setting none(Mesh_soup{});
  BOOST_TEST(none.basis.components().empty());
  BOOST_TEST(none.basis.number_of_loops() == 0);
}

// On a flat torus of squares, the shortest loops run along the axes.
BOOST_AUTO_TEST_CASE(shortest_on_a_flat_torus)
{
  const Surface mesh = to_mesh<Surface>(torus(8, 6, 3, 1));
  std::map<Surface::Edge_index, double> lengths = edge_lengths(mesh, Flat_torus_metric{8, 6, 12, 10});
  const auto map = boost::make_assoc_property_map(lengths);
  using Metric = FG::Edge_length_metric<Surface, std::decay_t<decltype(map)>>;
  using Length_triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  const Length_triangulation triangulation(mesh, Metric(mesh, map));
  const FG::Loop_basis<Length_triangulation> basis(triangulation, std::vector<FG::Vertex_index>{17_v});
  BOOST_TEST_REQUIRE(basis.number_of_loops() == 2);
  BOOST_TEST(std::abs(basis.length(0) - 10) < 1e-12);
  BOOST_TEST(std::abs(basis.length(1) - 12) < 1e-12);
  BOOST_TEST(basis.loop(0).size() == 6u);
  BOOST_TEST(basis.loop(1).size() == 8u);
  for(const auto& [p, q] : {std::pair(1, 0), std::pair(0, 1), std::pair(2, 3), std::pair(-3, 1), std::pair(5, -2)}) {
    Input_chain chain;
    for(auto h : halfedges_along(mesh, torus_loop(8, 6, p, q), true))
      chain.push_back(triangulation.input().index(h));
    const auto c = basis.homology_class(chain);
    BOOST_TEST(std::abs(c[0]) == std::abs(q));
    BOOST_TEST(std::abs(c[1]) == std::abs(p));
    BOOST_TEST(!basis.is_contractible(chain));
  }
}

// The three loops around the holes and the three through them generate the homology: their classes have determinant 1.
BOOST_AUTO_TEST_CASE(classes_on_a_plate)
{
  const Setting s(genus_3_plate(2));
  std::vector<std::vector<double>> m;
  for(const Vertex_sequence& loop : genus_3_loops(2)) {
    const Class c = s.basis.homology_class(s.through(loop));
    m.emplace_back(c.begin(), c.end());
  }
  double determinant = 1;
  for(std::size_t i = 0; i < m.size(); ++i) {
    std::size_t pivot = i;
    for(std::size_t j = i; j < m.size(); ++j)
      pivot = std::abs(m[j][i]) > std::abs(m[pivot][i]) ? j : pivot;
    std::swap(m[i], m[pivot]);
    determinant *= m[i][i];
    BOOST_TEST_REQUIRE(determinant != 0);
    for(std::size_t j = i + 1; j < m.size(); ++j)
      for(std::size_t k = m.size(); k-- > i;)
        m[j][k] -= m[j][i] / m[i][i] * m[i][k];
  }
  BOOST_TEST(std::abs(std::abs(determinant) - 1) < 1e-9);
}

// A ring about the plate between two holes bounds a part of the surface on either side, and no disk.
BOOST_AUTO_TEST_CASE(separating_and_not_contractible)
{
  const Mesh_soup soup = genus_3_plate(1);
  const Setting s(soup);
  const Input_chain ring = s.through(vertices_on_polyline(soup, {{2, 0, 0}, {2, 3, 0}, {2, 3, 1}, {2, 0, 1}}, true));
  BOOST_TEST(s.basis.homology_class(ring) == s.zero());
  BOOST_TEST(!s.basis.is_contractible(ring));
  Random_numbers random(3);
  for(int i = 0; i < 20; ++i) {
    const Input_chain chain = wandered(s, ring, 0_v, 60, random);
    BOOST_TEST(s.basis.homology_class(chain) == s.zero());
    BOOST_TEST(!s.basis.is_contractible(chain));
  }
  const Setting opened(punctured(soup, 1));
  std::vector<Chain> borders;
  FG::border_loops(opened.triangulation, std::back_inserter(borders));
  BOOST_TEST_REQUIRE(borders.size() == 1u);
  BOOST_TEST(borders[0].size() == 3u);
  for(FG::Halfedge_index h : borders[0])
    BOOST_TEST((!opened.triangulation.is_border(h) && opened.triangulation.is_border(Triangulation::twin(h))));
  BOOST_TEST(opened.basis.homology_class(Setting::input_chain(borders[0])) == opened.zero());
  BOOST_TEST(!opened.basis.is_contractible(Setting::input_chain(borders[0])));
}

// Moves over faces change no class. Commutators of the basis are contractible on a torus and nowhere else.
BOOST_AUTO_TEST_CASE(classes_do_not_change_by_moves_over_faces)
{
  Random_numbers random(1);
  for(const Mesh_soup& soup : {torus(5, 4, 3, 1), plate(2), plate(4), punctured(plate(2), 1), punctured(plate(3, 2), 4),
                               punctured(torus(5, 4, 3, 1), 2), grid_with_hole(5, 5, 2, 3, 2, 3)})
  {
    const Setting s(soup);
    const bool is_torus = s.basis.components()[0].genus == 1 && s.basis.components()[0].number_of_borders == 0;
    for(int i = 0; i < 10; ++i) {
      const Input_chain nothing = wandered(s, {}, 0_v, 300, random);
      BOOST_TEST(s.basis.is_contractible(nothing));
      BOOST_TEST(s.basis.homology_class(nothing) == s.zero());
    }
    for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i) {
      const Input_chain a = Setting::input_chain(s.basis.loop(i));
      const Input_chain b = wandered(s, a, 0_v, 100, random);
      BOOST_TEST(s.basis.homology_class(b) == s.unit(i));
      BOOST_TEST(!s.basis.is_contractible(b));
      for(FG::Index j = 0; j < i; ++j) {
        const Input_chain c = wandered(s, commutator(a, Setting::input_chain(s.basis.loop(j))), 0_v, 50, random);
        BOOST_TEST(s.basis.homology_class(c) == s.zero());
        BOOST_TEST(s.basis.is_contractible(c) == is_torus);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(several_components)
{
  const Mesh_soup two = disjoint_union(torus(5, 4, 3, 1), translated(plate(2), 10, 0, 0));
  const Mesh_soup soup = with_isolated_vertices(disjoint_union(two, translated(single_triangle(), 0, 20, 0)), 1, 1);
  const Setting s(soup, {30_v});
  BOOST_TEST_REQUIRE(s.basis.components().size() == 3u);
  BOOST_TEST(s.basis.components()[0].base_point == 30_v);
  BOOST_TEST(s.basis.components()[0].genus == 2);
  BOOST_TEST(s.basis.components()[0].number_of_loops == 4);
  BOOST_TEST(s.basis.components()[1].base_point == 1_v);
  BOOST_TEST(s.basis.components()[1].first_loop == 4);
  BOOST_TEST(s.basis.components()[1].genus == 1);
  BOOST_TEST(s.basis.components()[2].number_of_borders == 1);
  BOOST_TEST(s.basis.component(0_v) == -1);
  BOOST_TEST(s.basis.component(1_v) == 1);
  BOOST_TEST(s.basis.component(30_v) == 0);
  for(FG::Index i = 0; i < 6; ++i)
    BOOST_TEST(s.basis.homology_class(Setting::input_chain(s.basis.loop(i))) == s.unit(i));
  BOOST_TEST(s.basis.is_contractible(Input_chain()));
}

// Each loop of the basis pulled tight by itself, a part of them with points inserted on it, has the class that it had.
BOOST_AUTO_TEST_CASE(classes_stay_when_curves_are_pulled_tight)
{
  for(const Mesh_soup& soup : {genus_3_plate(3), punctured(plate(2, 3), 3), torus(12, 9, 3, 1)}) {
    Setting s(soup);
    for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i) {
      Network network(s.triangulation);
      const FG::Curve_index c = network.add_curve(s.basis.cycle(i), CGAL::parameters::is_closed(true));
      const double before = network.length(c);
      if(i % 2 == 1) {
        const auto h = FG::internal::as_input(s.basis.cycle(i).front());
        const auto& input = s.triangulation.input();
        for(const FG::Input_halfedge_index g : {h, input.twin(h)})
          if(!input.is_border(g)) {
            network.insert({g, {{0.25, 0.75, 0}}});
            network.insert({input.next(g), {{0.5, 0.25, 0.25}}});
            network.insert({input.previous(g), {{0.5, 0.5, 0}}});
          }
      }
      BOOST_TEST(s.basis.homology_class(network, c) == s.unit(i));
      FG::shorten(network);
      BOOST_TEST(!network.is_contracted(c));
      BOOST_TEST(network.length(c) <= before);
      BOOST_TEST(s.basis.homology_class(network, c) == s.unit(i));
      BOOST_TEST(!s.basis.is_contractible(network, c));
      network.clear();
      s.triangulation.rollback();
    }
  }
}

// All loops of a component at once, held at the base point.
BOOST_AUTO_TEST_CASE(all_loops_in_one_network)
{
  for(const Mesh_soup& soup : {genus_3_plate(3), punctured(plate(2, 3), 3), torus(12, 9, 3, 1)}) {
    Setting s(soup, {7_v});
    Network network(s.triangulation);
    for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i)
      network.add_curve(s.basis.loop(i));
    FG::order_overlapping_curves(network);
    BOOST_TEST(network.is_valid());
    FG::shorten(network);
    BOOST_TEST(network.is_valid());
    for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i) {
      BOOST_TEST(s.triangulation.tail(network.halfedge(network.first_segment(FG::Curve_index(i)))) == 7_v);
      BOOST_TEST(s.basis.homology_class(network, FG::Curve_index(i)) == s.unit(i));
    }
  }
}

// Curves that hardly run along edges: from points of edges into faces on either side, and on to vertices.
BOOST_AUTO_TEST_CASE(classes_of_curves_through_inserted_points)
{
  for(const Mesh_soup& soup : {genus_3_plate(2), punctured(plate(2, 3), 3), torus(12, 9, 3, 1)}) {
    Setting s(soup);
    const auto& input = s.triangulation.input();
    for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i)
      for(bool is_right : {false, true}) {
        std::vector<FG::Surface_location> polyline;
        for(const FG::Input_halfedge_index h : Setting::input_chain(s.basis.cycle(i))) {
          const FG::Input_halfedge_index g = is_right ? input.twin(h) : h;
          const double start = is_right ? 0.25 : 0.75;
          if(!input.is_border(g)) {
            polyline.push_back({g, {{start, 1 - start, 0}}});
            polyline.push_back({g, {{0.4, 0.4, 0.2}}});
          }
          polyline.push_back({g, is_right ? std::array<double, 3>{{1, 0, 0}} : std::array<double, 3>{{0, 1, 0}}});
        }
        Network network(s.triangulation);
        const FG::Curve_index c = FG::draw_polyline(network, polyline, CGAL::parameters::is_closed(true));
        BOOST_TEST(s.basis.homology_class(network, c) == s.unit(i));
        network.clear();
        s.triangulation.rollback();
      }
    // open, though its end and the corner that counts for it are one vertex
    Network network(s.triangulation);
    const FG::Input_halfedge_index h = input.is_border(0_input_h) ? 1_input_h : 0_input_h;
    const FG::Surface_location inside = {h, {{1, 1, 1}}};
    for(const std::array<double, 3>& corner : {std::array<double, 3>{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}) {
      FG::draw_polyline(network, {inside, FG::Surface_location{h, corner}});
      BOOST_CHECK_THROW(s.basis.homology_class(network, 0_c), FG::Invalid_curve_error);
      network.clear();
      s.triangulation.rollback();
    }
  }
}

// Words of a closed surface of genus 2, with the relation [a, b] [c, d], and of a torus.
BOOST_AUTO_TEST_CASE(words_of_fundamental_groups)
{
  using Word = std::vector<FG::internal::Letter>;
  const Word relation = {0, 2, 1, 3, 4, 6, 5, 7};
  const FG::internal::Surface_group group(relation);
  Random_numbers random(5);
  const auto with_relations = [&](Word word, int number) {
    for(; number > 0; --number) {
      const int first = random.below(8);
      const bool is_inverse = random.below(2) == 1;
      Word inserted;
      for(int i = 0; i < 8; ++i)
        inserted.push_back(is_inverse ? FG::internal::inverse_letter(relation[(first + 8 - i) % 8])
                                      : relation[(first + i) % 8]);
      word.insert(word.begin() + random.below(static_cast<int>(word.size()) + 1), inserted.begin(), inserted.end());
    }
    return word;
  };
  for(int i = 0; i < 200; ++i) {
    BOOST_TEST(group.is_neutral(with_relations({}, i % 20)));
    BOOST_TEST(!group.is_neutral(with_relations({0, 2, 1, 3}, i % 20)));       // [a, b]
    BOOST_TEST(!group.is_neutral(with_relations({0, 0, 4, 1, 1, 5}, i % 20))); // [a a, c]
    BOOST_TEST(!group.is_neutral(with_relations({0, 2, 5}, i % 20)));
  }
  const FG::internal::Surface_group torus_group(Word{0, 2, 1, 3});
  BOOST_TEST(torus_group.is_neutral({0, 0, 2, 2, 1, 1, 3, 3}));
  BOOST_TEST(!torus_group.is_neutral({0, 0, 2, 2, 1, 1, 3}));
  const FG::internal::Surface_group free_group(Word{});
  BOOST_TEST(free_group.is_neutral({0, 2, 3, 1}));
  BOOST_TEST(!free_group.is_neutral({0, 2, 1, 3}));
}

BOOST_AUTO_TEST_CASE(geodesic_loops_in_one_call)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const Setting s(punctured(plate(2, 3), 3));
  std::vector<std::vector<Point>> loops;
  const auto result = FG::geodesic_loop_basis(s.mesh, std::back_inserter(loops));
  BOOST_TEST_REQUIRE(loops.size() == 6u);
  BOOST_TEST_REQUIRE(result.report.curves.size() == 6u);
  std::size_t flips = 0;
  for(std::size_t i = 0; i < loops.size(); ++i) {
    double length = 0;
    for(std::size_t k = 1; k < loops[i].size(); ++k)
      length += std::sqrt(CGAL::squared_distance(loops[i][k - 1], loops[i][k]));
    BOOST_TEST((loops[i].front() == loops[i].back()));
    BOOST_TEST(std::abs(length - result.report.curves[i].length) < 1e-9 * length);
    BOOST_TEST(length <= s.basis.length(static_cast<FG::Index>(i)) * (1 + 1e-12));
    BOOST_TEST((result.report.curves[i].status == FG::Shortening_status::LOCALLY_SHORTEST));
    flips += result.report.curves[i].flips;
  }
  BOOST_TEST(result.report.flips == flips);
  BOOST_TEST(result.report.flip_outs > 0u);
  // stopped before the first step
  const auto stopped =
      FG::geodesic_loop_basis(s.mesh, loops.begin(), CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(0)));
  BOOST_TEST(stopped.report.flip_outs == 0u);
  BOOST_TEST((stopped.out == loops.end()));
  const Surface ball = to_mesh<Surface>(sphere(2));
  BOOST_TEST(FG::geodesic_loop_basis(ball, loops.begin()).report.curves.empty());
}

// A loop starts nowhere: from the wide end of a funnel it goes to the narrow one, around seams without width as well.
BOOST_AUTO_TEST_CASE(loops_have_no_fixed_point)
{
  const int n = 9;
  for(bool has_seam : {false, true}) {
    Mesh_soup funnel = mapped(cylinder(n, 4, 1, 3), [](const Coordinates& p) {
      return Coordinates{(4 - p[2]) * p[0], (4 - p[2]) * p[1], p[2]};
    });
    for(std::size_t i = 0; has_seam && i < funnel.points.size(); i += n)
      funnel.points[i + 1] = funnel.points[i];
    const Surface mesh = to_mesh<Surface>(funnel);
    std::vector<std::vector<Surface::Point>> loops;
    const auto result = FG::geodesic_loop_basis(mesh, std::back_inserter(loops));
    BOOST_TEST_REQUIRE(result.report.curves.size() == 1u);
    double narrow = 0;
    for(std::size_t i = 0; i < std::size_t(n); ++i)
      narrow += std::sqrt(CGAL::squared_distance(mesh.point(Surface::Vertex_index(unsigned(4 * n + i))),
                                                 mesh.point(Surface::Vertex_index(unsigned(4 * n + (i + 1) % n)))));
    BOOST_TEST(std::abs(result.report.curves[0].length - narrow) < 1e-12 * narrow);
    BOOST_TEST(result.report.curves[0].are_zero_edges_contracted == has_seam);
  }
}

// A curve that contracts, and one that is pulled to another side of inserted points.
BOOST_AUTO_TEST_CASE(curves_that_contract)
{
  Setting s(torus(12, 9, 3, 1));
  const FG::Input_halfedge_index h(20);
  Network network(s.triangulation);
  const auto& input = s.triangulation.input();
  const FG::Curve_index c =
      network.add_curve(Chain{FG::internal::as_intrinsic(h), FG::internal::as_intrinsic(input.next(h)),
                              FG::internal::as_intrinsic(input.previous(h))},
                        CGAL::parameters::is_closed(true));
  BOOST_TEST(s.basis.is_contractible(network, c));
  BOOST_TEST(FG::shorten(network).is_complete()); // nothing is shorter than a point
  BOOST_TEST(network.is_contracted(c));
  BOOST_TEST(s.basis.homology_class(network, c) == s.zero());
  BOOST_TEST(s.basis.is_contractible(network, c));
}

BOOST_AUTO_TEST_CASE(borders)
{
  const Setting s(punctured(plate(2, 2), 4));
  std::vector<Chain> borders;
  FG::border_loops(s.triangulation, std::back_inserter(borders));
  BOOST_TEST_REQUIRE(borders.size() == 4u);
  Class sum = s.zero();
  for(const Chain& border : borders) {
    const Class c = s.basis.homology_class(Setting::input_chain(border));
    BOOST_TEST(c != s.zero());
    for(std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += c[i];
  }
  BOOST_TEST(sum == s.zero()); // all borders together bound the surface
  borders.clear();
  const Setting closed(plate(2));
  FG::border_loops(closed.triangulation, std::back_inserter(borders));
  BOOST_TEST(borders.empty());
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  Setting s(torus(5, 4, 3, 1));
  using Vertices = std::vector<FG::Vertex_index>;
  BOOST_CHECK_THROW(Basis(s.triangulation, Vertices{0_v, 3_v}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(Basis(s.triangulation, Vertices{20_v}), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(Setting(with_isolated_vertices(single_triangle(), 1, 0), {0_v}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(s.basis.homology_class(Input_chain{0_input_h}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(s.basis.homology_class(Input_chain{120_input_h}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(s.basis.is_contractible(Input_chain{FG::null_index}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(s.basis.is_contractible(Input_chain{0_input_h, 0_input_h}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(s.basis.is_contractible(Input_chain{0_input_h, s.triangulation.input().previous(0_input_h)}),
                    FG::Invalid_curve_error);
  Network network(s.triangulation);
  network.add_curve(Chain{0_h});
  BOOST_CHECK_THROW(s.basis.homology_class(network, 0_c), FG::Invalid_curve_error);

  // two triangles that share a vertex; a quadrilateral; a length that is no number
  const Mesh_soup bow_tie = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  BOOST_CHECK_THROW(Setting{bow_tie}, FG::Invalid_mesh_error);
  // two tetrahedra that share a vertex: no border tells it
  Surface closed = to_mesh<Surface>(disjoint_union(tetrahedron(), tetrahedron()));
  const auto around = CGAL::halfedges_around_target(closed.halfedge(Surface::Vertex_index(4)), closed);
  for(Surface::Halfedge_index h : std::vector<Surface::Halfedge_index>(around.begin(), around.end()))
    closed.set_target(h, Surface::Vertex_index(0));
  closed.set_halfedge(Surface::Vertex_index(4), Surface::null_halfedge());
  const Triangulation of_closed(closed);
  BOOST_CHECK_THROW(Basis{of_closed}, FG::Invalid_mesh_error);
  Surface square;
  const auto a = square.add_vertex({0, 0, 0}), b = square.add_vertex({1, 0, 0});
  square.add_face(a, b, square.add_vertex({1, 1, 0}), square.add_vertex({0, 1, 0}));
  const Triangulation of_square(square);
  BOOST_CHECK_THROW(Basis{of_square}, FG::Invalid_mesh_error);
  Mesh_soup broken = torus(5, 4, 3, 1);
  broken.points[7][1] = std::nan("");
  BOOST_CHECK_THROW(Setting{broken}, FG::Invalid_coordinate_error);
  for(double far : {1e100, 1e71}) {
    broken.points[7][1] = far;
    BOOST_CHECK_THROW(Setting{broken}, FG::Invalid_coordinate_error);
    const Surface mesh = to_mesh<Surface>(broken);
    Triangulation triangulation(mesh);
    Network network(triangulation);
    BOOST_CHECK_THROW(FG::add_cut_graph(network), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(FG::shortest_loop(triangulation), FG::Invalid_coordinate_error);
  }
}
