// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_in_face.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Polyline_drawer.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Surface_polyline.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>
#include <CGAL/Flip_geodesics/internal/surface/locations_in_faces.h>
#include <CGAL/Flip_geodesics/internal/triangulation/check_has_no_curves.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Takes changes of a triangulation back at the end of its scope, also after an exception. */
template <class Triangulation>
class Rollback
{
public:
  explicit Rollback(Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_before(triangulation.log_position())
  {
  }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  ~Rollback() { m_triangulation.rollback(m_before); }

private:
  Triangulation& m_triangulation;
  typename Triangulation::Log_position m_before;
};

/*
 * Pulls one path at a time straight, between points anywhere, and gives it as a polyline; the triangulation is the
 * input's before and after. So paths do not hold up one another, and may cross.
 */
template <class Triangulation>
class Path_straightener
{
  using Network = Edge_path_network<Triangulation>;

public:
  explicit Path_straightener(Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* A geodesic from a shortest edge path, pulled tight by `tighten(network)`; the point twice if both ends are in one
   * place. */
  template <class Tighten>
  Surface_polyline shortest(const Surface_location& p, const Surface_location& q, const Tighten& tighten)
  {
    const auto find_path = [&](Network&, Vertex_index v, Vertex_index w) {
      std::vector<Halfedge_index> path = intrinsic_edge_path(m_triangulation, v, w);
      if(path.empty() && v != w) // v and w are not vertices of the mesh
        throw_disconnected(m_triangulation.input().tail(p.halfedge), m_triangulation.input().tail(q.halfedge));
      return path;
    };
    return checked(pull(p, q, find_path, tighten));
  }

  Surface_polyline shortest(const Surface_location& p, const Surface_location& q)
  {
    return shortest(p, q, [](Network& network) { return shorten(network); });
  }

  /* The geodesic with the polyline's ends in its class, pulled tight by `tighten(network)`, unless all of it lies in one
   * face; empty if the polyline, snapped to edges, crosses itself. */
  template <class Tighten>
  Surface_polyline straightened_if_possible(const Surface_polyline& path, const Tighten& tighten)
  {
    if(is_in_one_face(path))
      return {path.front(), path.back()};
    const auto snap = [&](Network&, Vertex_index v, Vertex_index w) { return snapped(path, v, w); };
    return pull(path.front(), path.back(), snap, tighten);
  }

  /* The same by all flips that it takes. Vertices at the ends can lie between a path and the edges that it is snapped
   * to; if that makes it cross itself, the path itself is drawn instead. */
  Surface_polyline straightened(const Surface_polyline& path)
  {
    const auto tighten = [](Network& network) { return shorten(network); };
    const Surface_polyline result = straightened_if_possible(path, tighten);
    if(!result.empty())
      return result;
    const auto draw = [&](Network& network, Vertex_index, Vertex_index) {
      return Polyline_drawer<Network>(network)(path).halfedges;
    };
    return checked(pull(path.front(), path.back(), draw, tighten));
  }

  /* Throws what is in the way of the last path that crosses itself. */
  [[noreturn]] void throw_conflict() const { m_conflict.raise(); }

  /* The path along edges from vertex v, the polyline's start, to w, its end: points on edges move to the nearer end. */
  std::vector<Halfedge_index> snapped(const Surface_polyline& path, Vertex_index v, Vertex_index w) const
  {
    const auto& input = m_triangulation.input();
    Path_in_face<Triangulation> path_in_face(m_triangulation);
    std::vector<Halfedge_index> result;
    std::size_t last = 0; // the point at which the path has arrived
    Vertex_index at = v;
    for(std::size_t i = 1; i < path.size(); ++i) {
      const bool is_end = i + 1 == path.size();
      if(kind(path[i]) == Location_kind::FACE && !is_end)
        continue; // its neighbors lie in the same face
      const Input_halfedge_index face = common_face(input, path[last], path[last + 1]);
      const Vertex_index next = is_end ? w : nearest_vertex(input, path[i]);
      for(Halfedge_index h : path_in_face(face, at, next))
        if(!result.empty() && h == Triangulation::twin(result.back()))
          result.pop_back();
        else
          result.push_back(h);
      at = next;
      last = i;
    }
    return result;
  }

  /* What became of all paths together, as if they were one curve. */
  const Shortening_report& report() const { return m_report; }
  void clear_report() { m_report.curves.assign(1, report_of_nothing()); }

private:
  [[noreturn]] static void throw_disconnected(Vertex_index v, Vertex_index w)
  {
    throw Disconnected_endpoints_error("no path joins a point in a face of vertex " + std::to_string(v.idx()) +
                                           " and one in a face of vertex " + std::to_string(w.idx()),
                                       {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())});
  }

  const Surface_polyline& checked(const Surface_polyline& path) const
  {
    if(path.empty())
      throw_conflict();
    return path;
  }

  // Returns nothing if the path crosses itself.
  template <class MakePath, class Tighten>
  Surface_polyline pull(const Surface_location& p, const Surface_location& q, const MakePath& make_path,
                        const Tighten& tighten)
  {
    check_has_no_curves(m_triangulation, "a geodesic between points cannot be found");
    const Rollback<Triangulation> at_end(m_triangulation);
    Network network(m_triangulation);
    const Vertex_index v = network.insert(p), w = network.insert(q);
    const std::vector<Halfedge_index> path = make_path(network, v, w);
    if(path.empty())
      return {canonical_location(m_triangulation.input(), p),
              canonical_location(m_triangulation.input(), v == w ? p : q)};
    network.add_curve(path, false);
    m_conflict = order_if_possible(network);
    if(m_conflict)
      return {};
    note(tighten(network));
    Surface_polyline result;
    for(const Surface_point& point : Curve_extractor<Network>(network).surface_points(Curve_index(0)))
      result.push_back(canonical_location(m_triangulation.input(), surface_location(m_triangulation, point)));
    if(result.empty()) // contracted to its ends
      result = {p, q};
    return result;
  }

  void note(const Shortening_report& report)
  {
    Curve_report& all = m_report.curves.front();
    const Curve_report& one = report.curves.front();
    all.initial_length += one.initial_length;
    all.length += one.length;
    m_report.flips += report.flips;
    m_report.flip_outs += report.flip_outs;
    all.smallest_angle = (std::min)(all.smallest_angle, one.smallest_angle);
    if(one.status != Shortening_status::LOCALLY_SHORTEST && one.status != Shortening_status::CONTRACTED)
      all.status = one.status;
    all.verdict = (std::max)(all.verdict, one.verdict);
  }

  // Legs within a face are straight.
  Curve_report report_of_nothing() const
  {
    Curve_report report;
    report.verdict = Triangulation::Traits::Has_drift::value || is_input_rounded(m_triangulation)
                         ? Certificate_verdict::NOT_CERTIFIED
                         : Certificate_verdict::PROVEN;
    return report;
  }

  bool is_in_one_face(const Surface_polyline& path) const
  {
    std::vector<Input_halfedge_index> faces = faces_of_location(m_triangulation.input(), path.front());
    for(const Surface_location& p : path) {
      const std::vector<Input_halfedge_index> here = faces_of_location(m_triangulation.input(), p);
      faces.erase(
          std::remove_if(faces.begin(), faces.end(),
                         [&](Input_halfedge_index f) { return std::find(here.begin(), here.end(), f) == here.end(); }),
          faces.end());
    }
    return !faces.empty();
  }

  Triangulation& m_triangulation;
  Shortening_report m_report = {{report_of_nothing()}, 0, 0};
  Order_conflict m_conflict; // of the last path that was pulled
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H
