// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The input edges that intrinsic edges cross.

#include "test_intrinsic_triangulation/snapshots.h"

using namespace Flip_geodesics_test;

// Two ways to a word that share nothing: numbers of crossings as they are now, and the log of the flips.
BOOST_AUTO_TEST_CASE(words_traced_are_words_derived)
{
  Random_numbers random(12);
  long traced = 0, not_traced = 0, longest = 0;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 60 * scale; ++k) {
      Triangulation t(mesh);
      flip_at_random(t, 10 + random.below(90), random);
      FG::internal::Edge_sequences<Triangulation> words;
      FG::internal::Edge_sequence_tracer<Triangulation> tracer(t);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const FG::Index version = t.version(t.edge(h));
        FG::Edge_sequence word;
        if(!tracer(h, word)) {
          ++not_traced;
          continue;
        }
        FG::Edge_sequence expected = {FG::internal::as_input(h), {}, FG::null_index, t.tail(h), t.head(h)};
        if(version != 0)
          expected = words.sequence(t, {h, version});
        BOOST_TEST((word.along == expected.along && word.crossed == expected.crossed && word.face == expected.face));
        BOOST_TEST((word.tail == expected.tail && word.head == expected.head));
        longest = (std::max)(longest, long(word.crossed.size()));
        ++traced;
      }
    }
  }
  std::cout << traced << " words traced, the longest crosses " << longest << " edges; " << not_traced << " derived\n";
  BOOST_TEST(longest > 12);
  BOOST_TEST(not_traced > 0);
}

BOOST_AUTO_TEST_CASE(words_are_exact_and_straight)
{
  Random_numbers random(4);
  long words = 0, longest = 0;
  double worst_length = 0, worst_bend = 0;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 60 * scale; ++k) {
      Triangulation t(mesh);
      flip_at_random(t, 10 + random.below(90), random);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const FG::Edge_sequence word = t.edge_sequence(h), back = t.edge_sequence(t.twin(h)).reversed();
        BOOST_TEST((word.crossed == back.crossed && word.along == back.along));
        const int crossings = word.along == FG::null_index ? static_cast<int>(word.crossed.size()) : -1;
        BOOST_TEST(t.crossings(t.edge(h)) == crossings);
        BOOST_TEST((crossings != 0));
        const Unfolded unfolded = unfold(mesh, t, word);
        const FG::internal::Strip<Triangulation> strip(t, word);
        worst_length = (std::max)({worst_length, std::abs(double(t.length(h) / unfolded.length - 1)),
                                   std::abs(double(strip.length() / unfolded.length - 1))});
        worst_bend = (std::max)({worst_bend, strip.bend(), double(unfolded.largest_bend)});
        longest = (std::max)(longest, long(crossings));
        ++words;
      }
    }
  }
  std::cout << words << " words, the longest crosses " << longest << " edges; largest relative error of a length "
            << worst_length << ", largest bend " << worst_bend << '\n';
  BOOST_TEST(longest > 20);
  BOOST_TEST(worst_length < 1e-9);
  BOOST_TEST(worst_bend < 1e-8);
}

BOOST_AUTO_TEST_CASE(input_edges_are_counted_around_vertices)
{
  Random_numbers random(5);
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    for(int k = 0; k < 60 * scale; ++k) {
      t.rollback();
      flip_at_random(t, 60, random);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const std::vector<FG::Halfedge_index> outgoing_halfedges = outgoing_halfedges_at_tail(t, h);
        const bool has_border = std::any_of(outgoing_halfedges.begin(), outgoing_halfedges.end(),
                                            [&](FG::Halfedge_index g) { return t.clockwise(g) == FG::null_index; });
        if(has_border)
          continue;
        const int along = t.crossings(t.edge(h)) < 0 ? 1 : 0;
        BOOST_TEST(t.input_edges_in_wedge(h, h) + along == static_cast<int>(mesh.degree(t.vertex(t.tail(h)))));
      }
    }
  }
}
