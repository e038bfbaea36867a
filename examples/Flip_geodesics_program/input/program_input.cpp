// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/program_input.h"

#include "input/curve_input.h"
#include "input/data_input.h"
#include "input/drawn_input.h"
#include "input/input_text.h"
#include "input/mesh_input.h"
#include "input/obstacle_input.h"
#include "input/point_input.h"

#include <cstddef>
#include <cstdint>
#include <utility>

program::Input_mesh program::read_input_mesh(const Options& options)
{
  Input_text input = read_text(options.mesh);
  return options.is_repaired ? repair_mesh(std::move(input)) : Input_mesh(read_mesh(input));
}

std::vector<program::Network_request> program::read_requests(const Options& options, const Input_mesh& mesh)
{
  if(!options.network.empty())
    return {read_network(mesh, read_text(options.network))};
  if(!options.segmentation.empty())
    return {read_segmentation(mesh, read_text(options.segmentation), options.has_free_junctions)};
  if(options.has_seams)
    return {read_seams(mesh, read_text(options.mesh))};
  if(!options.sources.empty())
    return {tree_request(mesh, options.sources.front())};
  const std::vector<Curve_request> curves =
      options.random
          ? random_pairs(mesh, static_cast<std::size_t>(*options.random), static_cast<std::uint64_t>(options.seed))
      : !options.pairs.empty()  ? read_pairs(mesh, read_text(options.pairs))
      : !options.points.empty() ? read_point_curves(mesh, read_text(options.points), false)
      : !options.bezier.empty() ? read_point_curves(mesh, read_text(options.bezier), true)
      : !options.draw.empty()   ? read_drawn_curves(mesh, read_text(options.draw))
      : !options.edges.empty()  ? read_curves(mesh, read_text(options.edges), false)
      : !options.loop.empty()   ? read_curves(mesh, read_text(options.loop), true)
                                : single_pair(mesh, *options.from, *options.to);
  std::vector<Network_request> requests;
  for(const Curve_request& curve : curves)
    requests.push_back({{curve}, {}, {}});
  return requests;
}

program::Obstacles program::read_obstacles(const Options& options, const Input_mesh& mesh)
{
  return options.obstacles.empty() ? Obstacles() : read_obstacles(mesh, read_text(options.obstacles));
}
