// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_CURVE_SETTING_H
#define FLIP_GEODESICS_TEST_CURVE_SETTING_H

#include "Double_triangulation.h"
#include "generated_curves.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <map>
#include <vector>

namespace Flip_geodesics_test {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Length_map = boost::associative_property_map<std::map<boost::graph_traits<Surface>::edge_descriptor, double>>;
using Length_metric = CGAL::Flip_geodesics::Edge_length_metric<Surface, Length_map>;
using Length_triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<
    Surface, CGAL::Flip_geodesics::Intrinsic_triangulation_traits<Length_metric::Kernel>, Length_metric>;

/// A mesh, a triangulation of it and a network, that live together.
template <class Triangulation_>
struct Basic_curve_setting
{
  using Triangulation = Triangulation_;
  using Network = CGAL::Flip_geodesics::Edge_path_network<Triangulation>;
  using Search = CGAL::Flip_geodesics::Shortest_edge_path<Triangulation>;

  template <class... Arguments>
  explicit Basic_curve_setting(const Mesh_soup& soup, Arguments... arguments)
    : mesh(to_mesh<Surface>(soup))
    , triangulation(mesh, arguments...)
    , network(triangulation)
  {
  }

  CGAL::Flip_geodesics::Curve_index add_path(CGAL::Flip_geodesics::Vertex_index source,
                                             CGAL::Flip_geodesics::Vertex_index target)
  {
    return add_path_through({source, target});
  }

  CGAL::Flip_geodesics::Curve_index add_path_through(const Vertex_sequence& way_points)
  {
    Search search(triangulation);
    return network.add_curve(CGAL::Flip_geodesics::shortest_halfedges_through(search, way_points));
  }

  CGAL::Flip_geodesics::Curve_index add(const Vertex_sequence& vertices, bool is_closed)
  {
    return network.add_curve(
        CGAL::Flip_geodesics::halfedges_through(triangulation, vertices, CGAL::parameters::is_closed(is_closed)),
        CGAL::parameters::is_closed(is_closed));
  }

  template <class Stop = CGAL::Flip_geodesics::Never_stop_predicate>
  CGAL::Flip_geodesics::Shortening_report pull(const Stop& stop = Stop())
  {
    return CGAL::Flip_geodesics::shorten(network, CGAL::parameters::stop_predicate(stop));
  }

  /// Adds a path, pulls it tight, returns its report, and takes everything back.
  CGAL::Flip_geodesics::Curve_report pulled_path(CGAL::Flip_geodesics::Vertex_index source,
                                                 CGAL::Flip_geodesics::Vertex_index target)
  {
    add_path(source, target);
    return take_back();
  }

  CGAL::Flip_geodesics::Curve_report pulled(const Vertex_sequence& vertices, bool is_closed)
  {
    add(vertices, is_closed);
    return take_back();
  }

  /// The flipped halfedges, in order.
  std::vector<CGAL::Flip_geodesics::Halfedge_index> flips() const
  {
    std::vector<CGAL::Flip_geodesics::Halfedge_index> result;
    for(std::size_t i = 0; i < triangulation.log_position(); ++i)
      result.push_back(triangulation.flip_record(i).h);
    return result;
  }

  Surface mesh;
  Triangulation triangulation;
  Network network;

private:
  CGAL::Flip_geodesics::Curve_report take_back()
  {
    const CGAL::Flip_geodesics::Curve_report report = pull().curves.back();
    network.clear();
    triangulation.rollback();
    return report;
  }
};

using Curve_setting = Basic_curve_setting<Double_triangulation<Surface>>;

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_CURVE_SETTING_H
