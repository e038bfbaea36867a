// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_FLAT_TORI_H
#define FLIP_GEODESICS_TEST_FLAT_TORI_H

#include "generated_curves.h"
#include "generated_meshes.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

// Tori given by lengths, with faces that are exactly without area.
namespace Flip_geodesics_test {

/// Lengths from a few, at random, until no face violates the triangle inequality. Where one length is the sum of two
/// others, faces are without area, and fold some vertices onto one place.
template <class Mesh>
std::map<typename boost::graph_traits<Mesh>::edge_descriptor, double> lengths_with_flat_faces(
    const Mesh& mesh, const std::vector<double>& choice, unsigned seed)
{
  using Edge = typename boost::graph_traits<Mesh>::edge_descriptor;
  std::mt19937 random(seed); // its numbers are the same everywhere, as those of distributions are not
  const auto chosen = [&] { return choice[random() % choice.size()]; };
  std::map<Edge, double> lengths = edge_lengths(mesh, [&](int, int) { return chosen(); });
  for(bool has_changed = true; has_changed;) {
    has_changed = false;
    for(auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      std::array<Edge, 3> sides = {edge(h, mesh), edge(next(h, mesh), mesh), edge(prev(h, mesh), mesh)};
      std::sort(sides.begin(), sides.end(), [&](Edge a, Edge b) { return lengths[a] < lengths[b]; });
      if(lengths[sides[0]] + lengths[sides[1]] >= lengths[sides[2]])
        continue;
      lengths[sides[random() % 3]] = chosen();
      has_changed = true;
    }
  }
  return lengths;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_FLAT_TORI_H
