// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What holds after every refinement.

#ifndef FLIP_GEODESICS_TEST_REFINE_CHECKED_REFINEMENT_H
#define FLIP_GEODESICS_TEST_REFINE_CHECKED_REFINEMENT_H

#include "Curve_setting.h"
#include "descriptors.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using FG::internal::first_side;

using Certified_traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Certified_setting = Basic_curve_setting<FG::Intrinsic_triangulation<Surface, Certified_traits>>;

template <class Triangulation>
double area(const Triangulation& triangulation)
{
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  double sum = 0;
  for(const FG::Intrinsic_face& f : faces) {
    const double a = f.lengths[0], b = f.lengths[1], c = f.lengths[2];
    sum += std::sqrt((std::max)((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c), 0.0)) / 4;
  }
  return sum;
}

// By the cosine theorem, in degrees.
template <class Triangulation>
double smallest_angle(const Triangulation& triangulation)
{
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  double largest_cosine = -1;
  for(const FG::Intrinsic_face& f : faces)
    for(int i = 0; i < 3; ++i) {
      const double a = f.lengths[i], b = f.lengths[(i + 1) % 3], c = f.lengths[(i + 2) % 3];
      largest_cosine = (std::max)(largest_cosine, (b * b + c * c - a * a) / (2 * b * c));
    }
  return std::acos((std::min)(largest_cosine, 1.0)) * 180 / std::acos(-1.0);
}

template <class Setting>
void check_refined(Setting& s, double area_before, const std::vector<double>& lengths)
{
  BOOST_CHECK(s.triangulation.is_valid());
  BOOST_CHECK(s.network.is_valid());
  BOOST_CHECK(FG::is_delaunay(s.triangulation));
  BOOST_CHECK_CLOSE_FRACTION(area(s.triangulation), area_before, 1e-9);
  for(std::size_t c = 0; c < lengths.size(); ++c)
    BOOST_CHECK_CLOSE_FRACTION(s.network.length(FG::Curve_index(static_cast<FG::Index>(c))), lengths[c], 1e-11);
  const int characteristic = static_cast<int>(s.mesh.number_of_vertices()) -
                             static_cast<int>(s.mesh.number_of_edges()) + static_cast<int>(s.mesh.number_of_faces());
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(s.triangulation, std::back_inserter(faces));
  BOOST_CHECK_EQUAL(s.triangulation.number_of_vertices() - s.triangulation.number_of_edges() +
                        static_cast<int>(faces.size()),
                    characteristic);
  std::set<std::tuple<FG::Input_halfedge_index, double, double, double>> places;
  for(int v = static_cast<int>(s.mesh.number_of_vertices()); v < s.triangulation.number_of_vertices(); ++v) {
    const FG::Surface_location at = s.triangulation.location(Vertex_index(v));
    BOOST_CHECK(places.emplace(at.halfedge, at.weights[0], at.weights[1], at.weights[2]).second);
  }
}

template <class Setting>
std::vector<double> lengths_of_curves(const Setting& s)
{
  std::vector<double> lengths;
  for(FG::Curve_index c : descriptors<FG::Curve_index>(s.network.number_of_curves()))
    lengths.push_back(s.network.length(c));
  return lengths;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_REFINE_CHECKED_REFINEMENT_H
