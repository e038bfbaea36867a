// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// Points and polygons as they are in a file, in its order. All coordinates are finite, unless an `Input_text` may have
/// others; all indices are those of points.
struct Soup
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::string> remarks = {}; ///< a line for each thing that a user should know about the file
};

/// Makes a soup of triangles that are given by their points: equal points are one.
class Soup_of_triangles
{
public:
  /// The index of a point.
  std::size_t add_point(const Soup::Point_3& p)
  {
    const bool is_finite = std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    if(!is_finite) { // equal to none, and in no order
      m_soup.points.push_back(p);
      return m_soup.points.size() - 1;
    }
    const auto [place, is_new] = m_indices.try_emplace(p, m_soup.points.size());
    if(is_new)
      m_soup.points.push_back(p);
    return place->second;
  }
  void add_face(const std::vector<std::size_t>& face) { m_soup.faces.push_back(face); }

  std::size_t number_of_faces() const { return m_soup.faces.size(); }
  Soup release() { return std::move(m_soup); }

private:
  Soup m_soup;
  std::map<Soup::Point_3, std::size_t> m_indices;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H
