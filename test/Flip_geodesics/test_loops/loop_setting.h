// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_LOOPS_LOOP_SETTING_H
#define FLIP_GEODESICS_TEST_LOOPS_LOOP_SETTING_H

#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Surface>;
using Network = FG::Edge_path_network<Triangulation>;
using Basis = FG::Loop_basis<Triangulation>;
using Class = Basis::Homology_class;
using Chain = std::vector<FG::Halfedge_index>;
using Input_chain = std::vector<FG::Input_halfedge_index>;

namespace {

// A plate like `genus_3_plate()` with `genus` holes in a row.
Mesh_soup plate(int genus, int n = 1)
{
  const auto is_filled = [](int i, int j, int) { return j != 1 || i % 2 == 0; };
  return subdivided(scaled(voxel_surface(2 * genus + 1, 3, 1, is_filled), n), n);
}

// Without its first `n` triangles that share no vertex with others of them: as many borders.
Mesh_soup punctured(Mesh_soup soup, int n)
{
  std::vector<char> is_near(soup.points.size(), 0);
  for(std::size_t t = 0; n > 0 && t < soup.triangles.size();) {
    const Corners c = soup.triangles[t];
    if(is_near[c[0]] != 0 || is_near[c[1]] != 0 || is_near[c[2]] != 0) {
      ++t;
      continue;
    }
    is_near[c[0]] = is_near[c[1]] = is_near[c[2]] = 1;
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    --n;
  }
  BOOST_TEST_REQUIRE(n == 0);
  return soup;
}

// A mesh with its triangulation and basis.
struct Setting
{
  explicit Setting(const Surface& surface, const std::vector<FG::Vertex_index>& base_points = {})
    : mesh(surface)
    , triangulation(mesh)
    , basis(triangulation, base_points)
  {
  }

  explicit Setting(const Mesh_soup& soup, const std::vector<FG::Vertex_index>& base_points = {})
    : Setting(to_mesh<Surface>(soup), base_points)
  {
  }

  Class unit(FG::Index i, std::int64_t sign = 1) const
  {
    Class result(static_cast<std::size_t>(basis.number_of_loops()), 0);
    result[static_cast<std::size_t>(i)] = sign;
    return result;
  }

  Class zero() const { return Class(static_cast<std::size_t>(basis.number_of_loops()), 0); }

  Input_chain through(const Vertex_sequence& vertices) const
  {
    return input_chain(FG::halfedges_through(triangulation, vertices, CGAL::parameters::is_closed(true)));
  }

  static Input_chain input_chain(const Chain& chain)
  {
    Input_chain result;
    for(FG::Halfedge_index h : chain)
      result.emplace_back(h.idx());
    return result;
  }

  double length(const Chain& chain) const
  {
    double sum = 0;
    for(FG::Halfedge_index h : chain)
      sum += triangulation.length(h);
    return sum;
  }

  Surface mesh;
  Triangulation triangulation;
  Basis basis;
};

} // namespace

#endif // FLIP_GEODESICS_TEST_LOOPS_LOOP_SETTING_H
