// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REPAIR_REPORT_H
#define CGAL_FLIP_GEODESICS_REPAIR_REPORT_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsRepair
/// Lists the kinds of repairs that `polygon_soup_to_triangle_mesh()` makes and that a `Repair_report` counts.
enum class Repair {
  POINTS_NOT_FINITE,        ///< points with a NaN or infinite coordinate, whose polygons are removed
  POINTS_WELDED,            ///< points moved to another point within the weld tolerance
  POLYGONS_WITHOUT_POINTS,  ///< polygons removed because of an invalid index or a point that is not finite
  POLYGONS_COLLAPSED,       ///< polygons removed because they have fewer than three distinct corners
  CORNERS_REPEATED,         ///< corners removed because they coincide with the previous corner
  POLYGONS_SPLIT,           ///< polygons split because they pass through a point twice
  POLYGONS_TRIANGULATED,    ///< polygons with more than three corners, which were triangulated
  DUPLICATES_DROPPED,       ///< triangles removed because another triangle has the same corners
  POLYGONS_REVERSED,        ///< polygons reversed to match the orientation of their neighbors
  EDGES_CUT,                ///< edges with more than two faces, along which faces were cut apart
  VERTICES_SPLIT,           ///< vertices added as copies, each of which takes over some faces of its original
  POINTS_MERGED,            ///< points merged with a coincident point by stitching borders or removing corners
  DEGENERATE_FACES_FLIPPED, ///< triangles whose corners are collinear, removed by a flip of their longest edge
  DEGENERATE_FACES_DROPPED, ///< triangles deleted because their corners are collinear or two corners coincide
  POINTS_LEFT               ///< points left without faces because other repairs removed all their polygons
};

/// \ingroup PkgFlipGeodesicsRepair
/// The number of enumerators of `Repair`.
constexpr std::size_t number_of_repairs = static_cast<std::size_t>(Repair::POINTS_LEFT) + 1;

/// \ingroup PkgFlipGeodesicsRepair
/// Returns a phrase that states how often a repair was made, such as "2 points merged with coincident points".
inline std::string describe(Repair repair, std::size_t count)
{
  const auto counted = [count](const char* one, const char* several, const char* what) {
    return std::to_string(count) + ' ' + (count == 1 ? one : several) + ' ' + what;
  };
  switch(repair) {
  case Repair::POINTS_NOT_FINITE:
    return counted("point", "points", "without faces: a coordinate is not finite");
  case Repair::POINTS_WELDED:
    return counted("point", "points", "moved to other points within the weld tolerance");
  case Repair::POLYGONS_WITHOUT_POINTS:
    return counted("polygon", "polygons", "removed: a corner does not exist or has a coordinate that is not finite");
  case Repair::POLYGONS_COLLAPSED:
    return counted("polygon", "polygons", "removed: fewer than three distinct corners");
  case Repair::CORNERS_REPEATED:
    return counted("corner", "corners", "removed: equal to the previous corner");
  case Repair::POLYGONS_SPLIT:
    return counted("polygon", "polygons", "split at a point that occurred twice");
  case Repair::POLYGONS_TRIANGULATED:
    return counted("polygon", "polygons", "triangulated: more than three corners");
  case Repair::DUPLICATES_DROPPED:
    return counted("triangle", "triangles", "removed: the same corners as another triangle");
  case Repair::POLYGONS_REVERSED:
    return counted("polygon", "polygons", "reversed to match the orientation of the neighbors");
  case Repair::EDGES_CUT:
    return counted("edge", "edges", "cut open: more than two faces");
  case Repair::VERTICES_SPLIT:
    return counted("vertex", "vertices", "added where faces met without a common edge");
  case Repair::POINTS_MERGED:
    return counted("point", "points", "merged with coincident points");
  case Repair::DEGENERATE_FACES_FLIPPED:
    return counted("degenerate triangle", "degenerate triangles", "removed by flips");
  case Repair::DEGENERATE_FACES_DROPPED:
    return counted("degenerate triangle", "degenerate triangles", "removed");
  case Repair::POINTS_LEFT:
    return counted("point", "points", "left without faces");
  }
  return {};
}

namespace internal {

template <class Model>
struct Internals;

/* The data of a Repair_report. Pairs of point and vertex, and of polygon and face, are sorted. */
struct Repair_record
{
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

  void add(Repair repair, std::size_t count = 1) { counts[static_cast<std::size_t>(repair)] += count; }

  std::array<std::size_t, number_of_repairs> counts = {};
  std::size_t number_of_points = 0, number_of_polygons = 0;
  std::vector<std::size_t> point_of_vertex, polygon_of_face;
  Pairs vertices_of_points, faces_of_polygons;
  std::size_t near_border_edges = 0;
  double near_border_distance = 0; // relative to the longest side of the bounding box
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsRepair
 *
 * Reports the repairs made by `polygon_soup_to_triangle_mesh()`, and the correspondence between the elements of the
 * mesh and those of the soup.
 *
 * Vertices and faces are identified by their positions in `vertices(mesh)` and `faces(mesh)`, and points and polygons
 * by their positions in the soup. The vertex at position `i` comes from point `i`; copies of split vertices follow the
 * vertices of all points. The vertex of a point is isolated if the point was merged into another one, has no remaining
 * polygons, or is not finite.
 */
class Repair_report
{
public:
  /// The vertices that come from a point, or the triangles that come from a polygon, in ascending order.
  using Elements = std::vector<std::size_t>;

  Repair_report() = default;

  /// Returns how often a repair of a given kind was made.
  std::size_t number_of(Repair repair) const { return m_record.counts[static_cast<std::size_t>(repair)]; }

  /// Returns whether no repair was made. If so, the mesh has the same elements as the soup, in the same order.
  bool is_empty() const
  {
    return std::all_of(m_record.counts.begin(), m_record.counts.end(), [](std::size_t count) { return count == 0; });
  }

  /// Returns the number of border edges that remain open although they nearly coincide with other border edges. Two
  /// border edges nearly coincide if the coordinates of their ends differ by at most 1e-6 times the longest side of the
  /// bounding box of the borders. Border edges shorter than a few times this bound are not counted.
  std::size_t number_of_near_border_edges() const { return m_record.near_border_edges; }

  /// Returns the largest distance between border edges that nearly coincide, or 0 if there are no such edges. The
  /// distance is relative to the longest side of the bounding box of the borders. A weld tolerance larger than this
  /// distance makes these edges coincide.
  double distance_of_near_border_edges() const { return m_record.near_border_distance; }

  /// Returns the report as lines of text without line ends. There is one line for each kind of repair that was made. If
  /// border edges nearly coincide, one more line reports them.
  std::vector<std::string> lines() const
  {
    std::vector<std::string> result;
    for(std::size_t i = 0; i < number_of_repairs; ++i)
      if(m_record.counts[i] > 0)
        result.push_back(describe(static_cast<Repair>(i), m_record.counts[i]));
    if(m_record.near_border_edges > 0)
      result.push_back(near_border_edges_in_sequences());
    return result;
  }

  /// Returns the number of points of the soup.
  std::size_t number_of_points() const { return m_record.number_of_points; }

  /// Returns the number of polygons of the soup.
  std::size_t number_of_polygons() const { return m_record.number_of_polygons; }

  /// Returns the point from which a vertex of the mesh comes.
  std::size_t point_of_vertex(std::size_t vertex) const { return m_record.point_of_vertex[vertex]; }

  /// Returns the polygon from which a face of the mesh comes.
  std::size_t polygon_of_face(std::size_t face) const { return m_record.polygon_of_face[face]; }

  /// Returns the vertices that come from a point and have faces. If the vertex of the point was split, the result
  /// contains several vertices. If the point was merged into another point, the result contains vertices of that
  /// point. If the point has no faces and was not merged, the result is empty.
  Elements vertices_of_point(std::size_t point) const { return elements(m_record.vertices_of_points, point); }

  /// Returns the triangles that come from a polygon. The result is empty if the polygon was removed, or if flips have
  /// merged it into its neighbors.
  Elements faces_of_polygon(std::size_t polygon) const { return elements(m_record.faces_of_polygons, polygon); }

private:
  friend struct internal::Internals<Repair_report>;

  explicit Repair_report(internal::Repair_record record)
    : m_record(std::move(record))
  {
  }

  std::string near_border_edges_in_sequences() const
  {
    std::ostringstream text;
    text.precision(2);
    const bool is_one = m_record.near_border_edges == 1;
    text << m_record.near_border_edges << " border edge" << (is_one ? " nearly coincides" : "s nearly coincide")
         << " with others and stay" << (is_one ? "s" : "") << " open: a weld tolerance above about "
         << m_record.near_border_distance << " stitches " << (is_one ? "it" : "them");
    return text.str();
  }

  static Elements elements(const internal::Repair_record::Pairs& pairs, std::size_t key)
  {
    Elements result;
    for(auto it = std::lower_bound(pairs.begin(), pairs.end(), std::make_pair(key, std::size_t(0)));
        it != pairs.end() && it->first == key; ++it)
      result.push_back(it->second);
    return result;
  }

  internal::Repair_record m_record;
};

namespace internal {

template <>
struct Internals<Repair_report>
{
  static Repair_report make(Repair_record record) { return Repair_report(std::move(record)); }
};

} // namespace internal

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_REPAIR_REPORT_H
