// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The windows that a field is made of.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(windows_of_an_edge_are_ordered)
{
  // Where there are many ties, some of which are broken later.
  for(const Mesh_soup& soup : {cube(4), cube(8), cylinder(12, 6, 1, 2), saddle_disk(6, 4, 3 * pi)}) {
    const Asked_surface s(soup);
    std::mt19937 random(1);
    for(int round = 0; round < 20; ++round) {
      FG::internal::Window_propagation<Triangulation> propagation(s.triangulation, true);
      for(std::size_t i = 0; i < 3; ++i) {
        const FG::Index v = static_cast<FG::Index>(random() % 1000) % s.triangulation.number_of_vertices();
        propagation.add_vertex(Vertex_index(v), 0.25 * static_cast<double>(i), i);
      }
      propagation.run(infinity, 1000000);
      for(FG::Index e = 0; e < s.triangulation.number_of_halfedges() / 2; ++e) {
        const auto windows = propagation.windows().on_edge(e);
        BOOST_TEST(std::is_sorted(windows.begin(), windows.end(),
                                  [](const auto& v, const auto& w) { return v.from < w.from; }));
      }
    }
  }
}

// On a mesh that is larger by a power of two there are as many windows, and distances are larger by the same factor.
BOOST_AUTO_TEST_CASE(windows_do_not_depend_on_the_size_of_the_mesh)
{
  for(const Mesh_soup& soup : {bumpy_sphere(5, 0.3, 1), saddle_disk(6, 4, 3 * pi), cube(4)}) {
    std::vector<std::size_t> windows;
    std::vector<std::vector<double>> distances;
    for(const double size : {1., 0x1p40, 0x1p-40}) {
      const Asked_surface s(mapped(soup, [=](const Coordinates& p) {
        return Coordinates{p[0] * size, p[1] * size, p[2] * size};
      }));
      FG::internal::Window_propagation<Triangulation> propagation(s.triangulation, true);
      propagation.add_vertex(Vertex_index(0), 0, 0);
      propagation.run(infinity, 1000000);
      windows.push_back(propagation.number_of_windows());
      distances.emplace_back();
      for(FG::Index v = 0; v < s.triangulation.number_of_vertices(); ++v)
        distances.back().push_back(propagation.vertex(Vertex_index(v)).distance / size);
    }
    for(std::size_t i = 1; i < 3; ++i) {
      BOOST_TEST(windows[i] == windows[0]);
      BOOST_TEST(distances[i] == distances[0], boost::test_tools::per_element());
    }
  }
}

// What a window says of its rays, against the same told another way.
BOOST_AUTO_TEST_CASE(formulas_of_windows)
{
  std::mt19937 random(37);
  const auto number = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random() % 1000000) / 1e6;
  };
  for(int round = 0; round < 400; ++round) {
    const double length = number(1, 3), angle = number(0.1, 3);
    FG::internal::Window w = {number(0, 0.4),
                              number(0.6, 1),
                              number(-1, 4),
                              number(0.1, 2),
                              0.25,
                              0,
                              0,
                              false,
                              FG::internal::Window_state::WAITING};
    w.is_far = round % 2 == 0;
    if(w.is_far) {
      w.x = std::cos(angle);
      w.y = std::sin(angle);
    }
    double least = infinity;
    for(int i = 0; i <= 1000; ++i)
      least = (std::min)(least, w.distance(w.from + (w.to - w.from) * i / 1000));
    BOOST_TEST(w.least_distance() <= least + 1e-12);
    BOOST_TEST(w.least_distance() >= least - 1e-5);
    const double b = number(w.from, w.to), height = number(0, 1);
    BOOST_TEST(std::abs(w.slope(b) - (w.distance(b + 1e-5) - w.distance(b - 1e-5)) / 2e-5) < 1e-8);
    const double place = w.crossing(b, height); // the ray does not bend there
    BOOST_TEST(std::abs(w.distance(b, height) - w.distance(place) - std::hypot(b - place, height)) < 1e-12);
    FG::internal::Window mirrored = w;
    mirrored.mirror(length);
    BOOST_TEST(std::abs(mirrored.from + w.to - length) < 1e-12);
    BOOST_TEST(std::abs(mirrored.to + w.from - length) < 1e-12);
    BOOST_TEST(std::abs(mirrored.distance(length - b, height) - w.distance(b, height)) < 1e-12);
  }
}

// About as many windows are made as are kept, those of an edge hardly overlap, and a field of vertices only gives them
// back. Where rays can go on from vertices that cannot be shortest, there are half as many more.
BOOST_AUTO_TEST_CASE(windows_are_few)
{
  using Propagation = FG::internal::Window_propagation<Triangulation>;
  const auto flat = mapped(bumpy_sphere(8, 0.4, 3), [](const Coordinates& p) {
    return Coordinates{p[0], p[1], 0.2 * p[2]};
  });
  const std::vector<std::pair<std::size_t, Mesh_soup>> most_windows = {
      {4400, bumpy_sphere(12, 0.3, 1)}, {13250, jittered_grid(24, 24, Diagonal_rule::RANDOM, 0.2, 3)},
      {5320, torus(26, 14, 2, 1)},      {1700, flat_grid(14, 14, Diagonal_rule::RANDOM)},
      {1800, genus_3_plate(2)},         {2280, flat}};
  std::size_t all_kept = 0, all_room = 0;
  for(const auto& [most, soup] : most_windows) {
    const Asked_surface s(soup);
    const auto& input = s.triangulation.input();
    Propagation whole(s.triangulation, true), passing(s.triangulation, false);
    for(Propagation* propagation : {&whole, &passing}) {
      propagation->add_vertex(5_v, 0, 0);
      propagation->run(infinity, std::numeric_limits<std::size_t>::max());
      BOOST_TEST(propagation->reach() == infinity);
    }
    std::size_t kept = 0, left = 0;
    double covered = 0, length = 0;
    for(FG::Index e = 0; e < s.triangulation.number_of_edges(); ++e) {
      kept += whole.windows().on_edge(e).size();
      left += passing.windows().on_edge(e).size();
      const auto h = FG::Input_halfedge_index(2 * e);
      length += whole.sides().copy(input.is_border(h) ? FG::internal::twin_index(h) : h).length;
      for(const FG::internal::Window& w : whole.windows().on_edge(e))
        covered += w.to - w.from;
    }
    BOOST_TEST(whole.number_of_windows() <= most);
    BOOST_TEST(whole.number_of_windows() <= 1.2 * kept);
    BOOST_TEST(covered <= 1.001 * length);
    BOOST_TEST(passing.number_of_windows() <= 1.01 * whole.number_of_windows());
    BOOST_TEST(passing.capacity() <= 0.55 * whole.capacity());
    BOOST_TEST(left <= 0.02 * kept);
    all_kept += kept;
    all_room += whole.capacity();
  }
  BOOST_TEST(all_room <= 1.75 * all_kept);
}

// Rays can be lost in a face that is almost a line.
BOOST_AUTO_TEST_CASE(flat_faces_are_told)
{
  for(double height : {1e-11, 1e-3}) {
    const Asked_surface s(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}, {1, height, 0}, {0.9, -1, 0}},
                                    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}}});
    Field field(s.triangulation, s.mesh);
    field.add_source(5_v);
    BOOST_TEST(field.compute().has_flat_face == (height < 1e-10));
  }
}

// From a vertex on the longest side of a degenerate face, and past it, light goes on into the face beyond.
BOOST_AUTO_TEST_CASE(light_passes_faces_without_area)
{
  // A square with one vertex on its diagonal, and with two.
  const std::vector<Mesh_soup> soups = {
      {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}}, {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}},
      {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 3, 0}},
       {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {0, 4, 5}, {0, 5, 2}, {0, 2, 3}}}};
  for(const Mesh_soup& soup : soups) {
    const Asked_surface s(soup);
    for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
      Field field(s.triangulation, s.mesh);
      field.add_source(v);
      BOOST_TEST(field.compute().has_flat_face);
      for(Vertex_index w : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
        const double expected = distance(soup.points[v.idx()], soup.points[w.idx()]);
        BOOST_TEST(std::abs(field.distance(w) - expected) <= 1e-12 * expected, v << " to " << w);
      }
    }
  }
}

// All corners of a tetrahedron on one line: rays go round and round those in between.
BOOST_AUTO_TEST_CASE(rays_that_go_round_faces_without_area_are_given_up)
{
  const Asked_surface s(
      Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  for(Vertex_index v : descriptors<Vertex_index>(4)) {
    Field field(s.triangulation, s.mesh);
    field.add_source(v);
    const auto report = field.compute();
    BOOST_TEST(report.has_flat_face);
    BOOST_TEST(report.windows < 100000u);
    BOOST_TEST((report.status == FG::Distance_field_status::COMPLETE) == (field.reach() == infinity));
    for(Vertex_index w : descriptors<Vertex_index>(4))
      if(field.distance(w) < infinity)
        BOOST_TEST(std::abs(field.distance(w) - std::abs(v.idx() - w.idx())) < 1e-12);
  }
}

// A computation whose edges get more and more windows ends long before the limit of all windows: where degenerate faces
// put vertices into one place, and where rays run round and round a tip that is so sharp that lengths hardly differ.
// Without either, an edge may have as many windows.
BOOST_AUTO_TEST_CASE(crowded_edges_end_a_field)
{
  const Mesh_soup line = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for(const auto& [soup, is_given_up] :
      {std::pair{line, true}, {cone(3, 1, 1, 1e5), true}, {cone(3, 1, 1, 1e4), false}}) {
    const Asked_surface s(soup);
    FG::internal::Window_propagation<Triangulation> propagation(s.triangulation, true);
    propagation.add_vertex(1_v, 0, 0);
    propagation.run(infinity, 200000);
    std::size_t most = 0;
    for(FG::Index e = 0; e < s.triangulation.number_of_edges(); ++e)
      most = (std::max)(most, static_cast<std::size_t>(propagation.windows().on_edge(e).size()));
    BOOST_TEST(propagation.is_given_up(std::numeric_limits<std::size_t>::max()) == is_given_up);
    BOOST_TEST((propagation.reach() < infinity) == is_given_up);
    BOOST_TEST(propagation.number_of_windows() < 100000u);
    BOOST_TEST(most > 2000u);
    BOOST_TEST(most < 20000u);
  }
}

BOOST_AUTO_TEST_CASE(the_default_limit_grows_like_the_windows)
{
  double windows = 0;
  for(int n : {40, 80}) { // four times the vertices have eight times the windows
    const Asked_surface s(torus(n, n, 2, 1));
    Field field(s.triangulation, s.mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
    field.add_source(0_v);
    const double more = static_cast<double>(field.compute().windows);
    BOOST_TEST(more < 9 * (windows > 0 ? windows : more));
    windows = more;
  }
  for(double vertices : {1e6, 1e8})
    BOOST_TEST(static_cast<double>(FG::Window_limit()(static_cast<std::size_t>(vertices))) >
               2 * windows * std::pow(vertices / (80 * 80), 1.5));
}
