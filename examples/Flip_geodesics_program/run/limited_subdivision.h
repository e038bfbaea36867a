// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_LIMITED_SUBDIVISION_H
#define CGAL_FLIP_GEODESICS_PROGRAM_LIMITED_SUBDIVISION_H

#include "messages.h"
#include "program_mesh.h"
#include "program_options.h"

#include <CGAL/Flip_geodesics/subdivide.h>

#include <algorithm>
#include <cstddef>

namespace program {

/// Returns the common subdivision of a triangulation and its mesh. The subdivision has a vertex at each crossing of
/// their edges; on a mesh of needles there can be a thousand per edge. \throws Bad_input if there are too many
template <class Triangulation>
auto limited_subdivision(const Triangulation& triangulation, const Mesh& mesh, const Mesh_result_options& options)
{
  namespace FG = CGAL::Flip_geodesics;
  const auto most_vertices = static_cast<std::size_t>(options.vertex_limit.value_or(5000000));
  auto number = static_cast<std::size_t>(triangulation.number_of_vertices());
  for(FG::Index e = 0; e < triangulation.number_of_edges(); ++e)
    number += static_cast<std::size_t>(std::max(triangulation.crossings(FG::Edge_index(e)), FG::Index(0)));
  if(number > most_vertices)
    throw Bad_input("the subdivided mesh would have " + readable(number) + " vertices, but at most " +
                    readable(most_vertices) +
                    " are allowed; thin triangles can cause this: remesh the surface, or increase --vertex-limit");
  return FG::common_subdivision(triangulation, mesh);
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_LIMITED_SUBDIVISION_H
