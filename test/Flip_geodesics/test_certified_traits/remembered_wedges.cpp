// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How wedges compare is remembered until their edges are flipped.

#include "descriptors.h"
#include "judged_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <map>

using namespace judged_test;

BOOST_AUTO_TEST_CASE(wedges_between_other_versions_are_others)
{
  using Side = FG::internal::Side_version;
  FG::internal::Compared_wedges wedges;
  const Side a = {0_h, 0}, b = {2_h, 0}, c = {2_h, 3};
  BOOST_TEST(wedges.find(a, b) == nullptr);
  wedges.insert(a, b, CGAL::LARGER);
  wedges.insert(a, c, CGAL::EQUAL);
  BOOST_TEST(wedges.find(b, a) == nullptr);
  BOOST_TEST((wedges.find({1_h, 0}, b) == nullptr && wedges.find(a, {2_h, 1}) == nullptr));
  BOOST_REQUIRE((wedges.find(a, b) != nullptr && wedges.find(a, c) != nullptr));
  BOOST_TEST((*wedges.find(a, b) == CGAL::LARGER && *wedges.find(a, c) == CGAL::EQUAL));
  wedges.forget_flips();
  BOOST_TEST((wedges.find(a, b) != nullptr && wedges.find(a, c) == nullptr));
  wedges.insert(a, c, CGAL::SMALLER);
  BOOST_REQUIRE(wedges.find(a, c) != nullptr);
  BOOST_TEST(*wedges.find(a, c) == CGAL::SMALLER);
}

BOOST_AUTO_TEST_CASE(a_limited_number_of_wedges_is_known_again)
{
  FG::internal::Compared_wedges wedges;
  const auto result = [](int i) { return static_cast<CGAL::Comparison_result>(i % 3 - 1); };
  const auto known = [&](int i) {
    return wedges.find({FG::Halfedge_index(i), i % 7}, {FG::Halfedge_index(i + 1), i % 5});
  };
  int wrong = 0, after_insertion = 0;
  std::map<int, int> found;
  for(int i = 0; i < 100000; ++i) {
    wedges.insert({FG::Halfedge_index(i), i % 7}, {FG::Halfedge_index(i + 1), i % 5}, result(i));
    after_insertion += known(i) != nullptr ? 1 : 0;
    if(i == 3000 || i == 99999)
      for(int k = 0; k <= i; ++k)
        if(const CGAL::Comparison_result* r = known(k)) {
          ++found[i];
          wrong += *r == result(k) ? 0 : 1;
        }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(after_insertion == 100000);
  BOOST_TEST(found[3000] == 3001);
  BOOST_TEST(found[99999] > 0);
  BOOST_TEST(found[99999] < 16384);
}

BOOST_AUTO_TEST_CASE(what_is_remembered_of_wedges_is_forgotten_with_their_flips)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  Random_numbers random(11);
  std::size_t remembered = 0;
  int wrong = 0;
  for(const Named_soup& shape : soups_full_of_ties()) {
    const Surface mesh = to_mesh<Surface>(shape.soup);
    Triangulation triangulation(mesh);
    FG::Decision_statistics statistics;
    const FG::internal::Wedge_comparison<Triangulation> compare(triangulation, statistics);
    for(int i = 0; i < 2000 * scale; ++i) {
      const FG::Halfedge_index h(random.below(2 * triangulation.number_of_edges()));
      if(triangulation.is_border(h) || triangulation.is_border(triangulation.twin(h)))
        continue;
      const FG::Halfedge_index from = triangulation.twin(triangulation.previous(triangulation.twin(h)));
      const bool is_reflex = compare(from, triangulation.next(h)) != CGAL::SMALLER;
      wrong += triangulation.is_reflex_at_head(h) == is_reflex ? 0 : 1;
      wrong += triangulation.is_reflex_at_head(h) == is_reflex ? 0 : 1;
      if(triangulation.is_flippable(h))
        triangulation.flip(h);
      if(random.below(20) == 0)
        triangulation.rollback(
            static_cast<std::size_t>(random.below(static_cast<int>(triangulation.log_position()) + 1)));
    }
    remembered += triangulation.decision_statistics().by_memory;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(remembered > 1000u);
}
