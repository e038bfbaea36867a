// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_H
#define CGAL_FLIP_GEODESICS_H

/*!
 * \file Flip_geodesics.h
 * \ingroup PkgFlipGeodesicsRef
 * Includes all headers of the package except the following, which must be included separately:
 * `Exact_intrinsic_triangulation_traits.h`; the headers that require Eigen, `Operators.h`, `Direction_field.h` and
 * `Conformal_flattening.h`; `insert_curves.h` and `polygon_soup_to_triangle_mesh.h`, which include headers of CGAL
 * packages licensed under the GPL; and `Repair_report.h`, which `polygon_soup_to_triangle_mesh.h` includes.
 */

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/IO/appearance.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/certify_curve.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/graph_traits.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/straightened_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/texture_coordinates.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#endif // CGAL_FLIP_GEODESICS_H
