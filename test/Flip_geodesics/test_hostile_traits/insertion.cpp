// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points and edges that are inserted among wrong flips.

#include "test_hostile_traits/checked_shortening.h"

using namespace Flip_geodesics_test;

namespace {

// One lie for each bad face.
struct Liars_start : FG::Default_shortening_visitor
{
  bool go_further()
  {
    *lies_left = 1;
    return true;
  }

  int* lies_left = nullptr;
};

} // namespace

// Flips of edges that must not be flipped, while points are inserted: the words tell, and the insertion is undone.
BOOST_AUTO_TEST_CASE(insertions_with_wrong_flips_are_taken_back)
{
  for(bool is_open : {false, true}) {
    std::size_t refused = 0;
    for(bool has_curve : {false, true})
      for(int k = 0; k < 24; k += stride_of_many) {
        Lies lies;
        const int periods[] = {2, 3, 5, 8, 13, 30};
        Liar liar(periods[k / 4], k % 4);
        int lies_left = 0;
        const Triangulation* lied_to = nullptr;
        lies.is_locally_delaunay = [&](bool truth) {
          const bool is_time =
              lied_to != nullptr && lied_to->is_inserted(Vertex_index(lied_to->number_of_vertices() - 1));
          return truth && !(is_time && lies_left > 0 && liar(false) && lies_left-- > 0);
        };
        Setting setting(is_open ? jittered_grid(5, 5, Diagonal_rule::RANDOM, 0.2, 1) : bumpy_sphere(4, 0.3, 2),
                        Hostile_traits(lies));
        if(has_curve)
          setting.add_path(0_v, is_open ? 17_v : 37_v);
        setting.pull();
        FG::flip_to_delaunay(setting.triangulation);
        lied_to = &setting.triangulation;
        const double length = has_curve ? setting.network.length(0_c) : 0;
        FG::Refinement_options options;
        options.smallest_angle = 28;
        options.longest_edge = 0.25;
        options.maximum_insertions = 300;
        Liars_start start;
        start.lies_left = &lies_left;
        const FG::Refinement_report report =
            FG::refine(setting.network, options, CGAL::parameters::visitor(std::ref(start)));
        refused += report.refused;
        BOOST_TEST(report.insertions + report.splits <= 300u);
        BOOST_TEST(report.insertions + report.splits + setting.mesh.number_of_vertices() ==
                   std::size_t(setting.triangulation.number_of_vertices()));
        if(has_curve)
          BOOST_TEST(std::abs(setting.network.length(0_c) - length) < 1e-9 * length);
        BOOST_TEST(setting.network.is_valid());
        for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
          BOOST_CHECK_NO_THROW(setting.triangulation.edge_sequence(FG::internal::first_side(e)));
      }
    BOOST_TEST(refused > 10u);
  }
}

namespace {

// Truth until so many questions were asked.
struct Late_start : FG::Default_shortening_visitor
{
  bool go_further()
  {
    *is_lying = --questions_left < 0;
    return true;
  }

  bool* is_lying = nullptr;
  Index questions_left = 0;
};

} // namespace

// Lies one after another: flips that do not lead to the vertex end, and are taken back.
BOOST_AUTO_TEST_CASE(refinement_among_wrong_flips_ends)
{
  std::size_t refused = 0;
  for(const Mesh_soup& soup : {jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 1),
                               flat_grid(5, 5, Diagonal_rule::RISING), bumpy_sphere(4, 0.3, 2)})
    for(int period : {1, 2, 3, 5, 7, 13, 30})
      for(bool has_curve : {false, true}) {
        Lies lies;
        Liar liar(period);
        bool is_lying = false;
        lies.is_locally_delaunay = [&](bool truth) { return is_lying ? liar(truth) : truth; };
        Setting setting(soup, Hostile_traits(lies));
        if(has_curve)
          setting.add_path(0_v, 35_v); // along the diagonals of the second, with circumcentres on it
        setting.pull();
        FG::flip_to_delaunay(setting.triangulation);
        const Index vertices = setting.triangulation.number_of_vertices();
        Late_start start;
        start.is_lying = &is_lying;
        start.questions_left = setting.triangulation.number_of_edges(); // those of the edges, before the faces
        FG::Refinement_options options;
        options.longest_edge = 0.5;
        options.maximum_insertions = 200;
        const FG::Refinement_report report =
            FG::refine(setting.network, options, CGAL::parameters::visitor(std::ref(start)));
        is_lying = false;
        refused += report.refused;
        BOOST_TEST(report.insertions + report.splits ==
                   std::size_t(setting.triangulation.number_of_vertices() - vertices));
        BOOST_TEST(setting.network.is_valid());
        for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
          BOOST_CHECK_NO_THROW(setting.triangulation.edge_sequence(FG::internal::first_side(e)));
      }
  BOOST_TEST(refused > 10u);
}

// A visitor that throws: the points that were inserted are gone.
BOOST_AUTO_TEST_CASE(an_exception_between_points_leaves_the_triangulation_as_it_was)
{
  struct Thrower : FG::Default_shortening_visitor
  {
    bool go_further() { throw std::runtime_error("enough"); }
  };
  const Setting setting(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 2));
  Triangulation triangulation(setting.mesh);
  const auto h = triangulation.input().index(halfedge(Surface::Face_index(3), setting.mesh));
  const auto g = triangulation.input().index(halfedge(Surface::Face_index(60), setting.mesh));
  const std::vector<FG::Surface_location> ends = {{h, {{0.25, 0.25, 0.5}}}, {g, {{0.5, 0.25, 0.25}}}};
  BOOST_CHECK_THROW(FG::geodesics_through(triangulation, ends, CGAL::parameters::visitor(Thrower())),
                    std::runtime_error);
  BOOST_TEST(triangulation.log_position() == 0u);
  BOOST_TEST(triangulation.number_of_vertices() == Index(setting.mesh.number_of_vertices()));
  FG::geodesics_through(triangulation, ends);
  BOOST_TEST(triangulation.log_position() == 0u);
  BOOST_TEST(triangulation.number_of_vertices() == Index(setting.mesh.number_of_vertices()));
}

// Vectors of about 100 bits that are derived from flip to flip, as those of the words, which are unfolded.
BOOST_AUTO_TEST_CASE(vectors_derived_over_wrong_flips_are_those_of_the_words)
{
  int compared = 0;
  for(unsigned seed = 1; seed <= 30; ++seed) {
    Random_numbers random(seed);
    Setting setting(shaken(seed % 2 == 0 ? octahedron(2) : flat_grid(4, 4, Diagonal_rule::RANDOM), 0.1, seed));
    const Triangulation& t = setting.triangulation;
    for(int i = 0; i < 60; ++i) {
      const Halfedge_index h(random.below(t.number_of_halfedges())), twin = t.twin(h);
      if(t.is_border(h) || t.is_border(twin) || t.next(h) == twin || t.next(twin) == h || t.crossings(t.edge(h)) > 100)
        continue;
      setting.triangulation.flip(h); // of any quad
    }
    for(Halfedge_index h : descriptors<Halfedge_index>(t.number_of_halfedges())) {
      const FG::internal::Precise_edge derived = // before its word is asked for, and then unfolded
          FG::internal::Internals<Setting::Triangulation>::precise_edge(t, h);
      const FG::Edge_sequence word = t.edge_sequence(h);
      if(word.crossed.empty())
        continue;
      const FG::internal::Precise_edge unfolded = FG::internal::Precise_strip<Triangulation>(t, word, false).edge();
      if(!derived.has_bound() || !unfolded.has_bound())
        continue;
      ++compared;
      BOOST_TEST(derived.tail_reference == unfolded.tail_reference);
      BOOST_TEST(derived.head_reference == unfolded.head_reference);
      const double error = FG::internal::length(derived.end + -unfolded.end);
      BOOST_TEST(error <= (derived.end_error + unfolded.end_error) * unfolded.length);
    }
  }
  BOOST_TEST(compared > 1000);
}

namespace {

// The edge i->j of a quadrilateral that is bent inwards at k, by so much: it passes outside of the mesh.
struct Bent_inwards
{
  explicit Bent_inwards(double height)
    : mesh(to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {1, height, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}}))
    , triangulation(mesh, Hostile_traits(lies()))
  {
    const Halfedge_index h = FG::internal::halfedge_between(triangulation, 1_v, 3_v);
    BOOST_REQUIRE(triangulation.is_flippable(h));
    triangulation.flip(h);
  }

  static const Lies& lies()
  {
    static const Lies convex = {[](bool) { return false; }, {}, {}, {}};
    return convex;
  }

  Surface mesh;
  Triangulation triangulation;
};

} // namespace

// Flips that were wrong by as little as rounding explains do not stand in the way of points on edges; others do.
BOOST_AUTO_TEST_CASE(points_on_edges_that_were_flipped_wrongly)
{
  for(double height : {1e-9, 1e-7, 1e-3, 0.1}) {
    Bent_inwards bent(height);
    const Halfedge_index along = FG::internal::halfedge_between(bent.triangulation, 0_v, 1_v);
    const Halfedge_index flipped = FG::internal::halfedge_between(bent.triangulation, 0_v, 2_v);
    // On the wrong side of the corner.
    const FG::Surface_location point = {FG::internal::as_input(along), {{1, 1, 1e-9}}};
    const auto split = [&] { return bent.triangulation.split_edge(flipped, point, 0, [](const auto&) {}); };
    const auto before = bent.triangulation.log_position();
    if(height < 1e-6) {
      BOOST_TEST(split() == 4_v);
      continue;
    }
    BOOST_CHECK_THROW(split(), FG::Insertion_error);
    BOOST_TEST(bent.triangulation.log_position() == before);
    BOOST_TEST(bent.triangulation.number_of_vertices() == 4);
  }
}

// Points among many wrong flips are inserted, or refused with nothing changed.
BOOST_AUTO_TEST_CASE(points_among_wrong_flips)
{
  int inserted = 0, refused = 0;
  for(int period : {1, 2, 4, 8})
    for(unsigned seed = 1; seed <= 20; ++seed) {
      Lies lies;
      Liar liar(period);
      lies.is_quad_reflex = [&](bool is_reflex) { return is_reflex && !liar(false); };
      Random_numbers random(seed);
      const Surface mesh = to_mesh<Surface>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.24, seed));
      Triangulation triangulation(mesh, Hostile_traits(lies));
      for(int i = 0; i < 60; ++i) {
        const Halfedge_index h(random.below(triangulation.number_of_halfedges()));
        if(triangulation.is_flippable(h))
          triangulation.flip(h);
      }
      for(int i = 0; i < 30; ++i) {
        const FG::Input_halfedge_index h(random.below(triangulation.input().number_of_halfedges()));
        if(triangulation.input().is_border(h))
          continue;
        const auto before = triangulation.log_position();
        const Index vertices = triangulation.number_of_vertices();
        try {
          triangulation.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}});
          ++inserted;
        } catch(const FG::Insertion_error&) {
          ++refused;
          BOOST_TEST(triangulation.log_position() == before);
          BOOST_TEST(triangulation.number_of_vertices() == vertices);
        }
      }
    }
  BOOST_TEST(inserted > 100);
  BOOST_TEST(refused > 30);
}
