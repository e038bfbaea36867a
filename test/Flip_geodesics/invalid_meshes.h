// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_INVALID_MESHES_H
#define FLIP_GEODESICS_TEST_INVALID_MESHES_H

#include "mesh_soup.h"

#include <ios>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

/*
 * Inputs that must be refused, as soups where a mesh can be built from them and as text of OFF files.
 */
namespace Flip_geodesics_test {

/// What is wrong with an input.
enum class Defect {
  UNREADABLE,
  EMPTY,
  POLYGON_FACES,
  NON_MANIFOLD,
  INDEX_OUT_OF_RANGE,
  DEGENERATE_FACE,
  INVALID_COORDINATE
};

struct Invalid_file
{
  std::string name;
  Defect defect;
  std::string off;
};

/// An OFF file with all digits of the coordinates.
inline std::string to_off(const Mesh_soup& soup)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "OFF\n" << soup.points.size() << ' ' << soup.triangles.size() << " 0\n";
  for(const Coordinates& p : soup.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const Corners& t : soup.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return out.str();
}

// A square of two triangles, 012 and 023, with a point 3 that is wrong; meshes can be built of these.

inline Mesh_soup square_with_point_3(const Coordinates& p)
{
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, p}, {{0, 1, 2}, {0, 2, 3}}};
}

/// The edge 23 has length zero.
inline Mesh_soup with_zero_length_edge() { return square_with_point_3({1, 1, 0}); }

/// The face 023 has area zero, exactly, and edges of positive length.
inline Mesh_soup with_zero_area_face() { return square_with_point_3({0.5, 0.5, 0}); }

inline Mesh_soup with_nan_coordinate() { return square_with_point_3({0, std::numeric_limits<double>::quiet_NaN(), 0}); }

inline Mesh_soup with_infinite_coordinate()
{
  return square_with_point_3({0, std::numeric_limits<double>::infinity(), 0});
}

/// Finite, but the squares of lengths are not.
inline Mesh_soup with_huge_coordinate() { return square_with_point_3({0, 1e200, 0}); }

// No mesh can be made of the following soups.

/// Three triangles at the edge 01.
inline Mesh_soup with_non_manifold_edge()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
}

/// Two tetrahedra that share vertex 0.
inline Mesh_soup with_non_manifold_vertex()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}};
}

/// The square, with one face turned over.
inline Mesh_soup with_inconsistent_orientation()
{
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}};
}

/// Five triangles in a band with a half twist; no orientation is consistent.
inline Mesh_soup moebius_band()
{
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
          {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}};
}

/// One file for each way of being wrong.
inline std::vector<Invalid_file> invalid_files()
{
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  return {{"no_file_content", Defect::UNREADABLE, ""},
          {"not_a_mesh", Defect::UNREADABLE, "A letter, and no mesh at all.\n"},
          {"truncated_points", Defect::UNREADABLE, "OFF\n4 2 0\n0 0 0\n1 0 0\n"},
          {"truncated_faces", Defect::UNREADABLE, "OFF\n4 2 0\n" + square + "3 0 1 2\n"},
          {"empty", Defect::EMPTY, "OFF\n0 0 0\n"},
          {"no_faces", Defect::EMPTY, "OFF\n4 0 0\n" + square},
          {"polygon_faces", Defect::POLYGON_FACES, "OFF\n4 1 0\n" + square + "4 0 1 2 3\n"},
          {"index_too_large", Defect::INDEX_OUT_OF_RANGE, "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 4\n"},
          {"index_negative", Defect::INDEX_OUT_OF_RANGE, "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 -1\n"},
          {"repeated_corner", Defect::DEGENERATE_FACE, "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 2\n"},
          {"zero_length_edge", Defect::DEGENERATE_FACE, to_off(with_zero_length_edge())},
          {"zero_area_face", Defect::DEGENERATE_FACE, to_off(with_zero_area_face())},
          {"nan_coordinate", Defect::INVALID_COORDINATE, to_off(with_nan_coordinate())},
          {"infinite_coordinate", Defect::INVALID_COORDINATE, to_off(with_infinite_coordinate())},
          {"overflowing_coordinate", Defect::INVALID_COORDINATE, "OFF\n3 1 0\n0 0 0\n1e999 0 0\n0 1 0\n3 0 1 2\n"},
          {"huge_coordinate", Defect::INVALID_COORDINATE, to_off(with_huge_coordinate())},
          {"non_manifold_edge", Defect::NON_MANIFOLD, to_off(with_non_manifold_edge())},
          {"non_manifold_vertex", Defect::NON_MANIFOLD, to_off(with_non_manifold_vertex())},
          {"inconsistent_orientation", Defect::NON_MANIFOLD, to_off(with_inconsistent_orientation())},
          {"moebius_band", Defect::NON_MANIFOLD, to_off(moebius_band())}};
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INVALID_MESHES_H
