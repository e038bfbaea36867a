// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Certificates, and what the referee says of the same curve.

#ifndef FLIP_GEODESICS_TEST_CERTIFY_SECOND_OPINION_H
#define FLIP_GEODESICS_TEST_CERTIFY_SECOND_OPINION_H

#include "Curve_setting.h"
#include "Referee.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Simple_cartesian<double>;
using Certified_setting =
    Basic_curve_setting<FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Kernel>>>;
using Settings = boost::mpl::list<Curve_setting, Certified_setting>;

inline std::vector<Mesh_soup> soups()
{
  return {flat_grid(7, 7, Diagonal_rule::RANDOM),
          jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1),
          cube(4),
          octahedron(4),
          tetrahedron(4),
          genus_3_plate(1),
          bumpy_sphere(4, 0.3, 2),
          needle_strip(7, 7, 0x1p20)};
}

// Angles of pi up to the rounding of the coordinates: doubles call them straight, which they are not.
inline std::vector<Mesh_soup> soups_near_ties()
{
  return {torus(12, 9, 3, 1), cylinder(9, 4, 1, 2), cone_disk(6, 3, 2), saddle_disk(6, 3, 8)};
}

// Certifies by the referee.
template <class Network>
class Second_opinion
{
public:
  using Triangulation = typename Network::Triangulation;
  using Shape = Shape_of_points<Surface>;

  Second_opinion(const Network& network, const Surface& mesh)
    : m_network(network)
    , m_referee(network.triangulation(), Shape(mesh))
  {
  }

  bool is_locally_shortest(FG::Curve_index curve)
  {
    bool result = true;
    m_network.for_each_segment(curve, [&](FG::Segment_index s) {
      result = result && m_referee.is_straight(m_network.triangulation().edge_sequence(m_network.halfedge(s))) &&
               !is_bent({s, FG::Side::LEFT}) && !is_bent({s, FG::Side::RIGHT});
    });
    return result;
  }

  bool is_bent(const FG::Joint& joint)
  {
    if(m_network.is_head_fixed(joint.incoming))
      return false;
    const auto [a, b] = m_network.ends(joint);
    if(m_network.next_clockwise(a) != b)
      return false;
    return m_network.is_turning_back(joint) || m_referee.compare_wedge(a.halfedge, b.halfedge) < 0;
  }

private:
  const Network& m_network;
  Referee<Triangulation, Shape> m_referee;
};

template <class Setting>
FG::Network_certificate checked_certificate(Setting& setting)
{
  const FG::Network_certificate certificate = FG::certify(setting.network);
  Second_opinion<typename Setting::Network> opinion(setting.network, setting.mesh);
  BOOST_TEST(certificate.curves.size() == std::size_t(setting.network.number_of_curves()));
  for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(setting.network.number_of_curves())) {
    const FG::Curve_certificate& curve = certificate.curves[c.idx()];
    BOOST_TEST(curve.is_locally_shortest() == opinion.is_locally_shortest(c));
    if(curve.verdict() == FG::Verdict::BENT_JOINT) {
      BOOST_TEST(setting.network.curve(curve.segment) == c);
      BOOST_TEST(opinion.is_bent({curve.segment, curve.side}));
    }
  }
  return certificate;
}

template <class Setting>
void add_random_path(Setting& setting, Random_numbers& random)
{
  const int n = setting.triangulation.number_of_vertices();
  const int u = random.below(n);
  setting.add_path(FG::Vertex_index(u), FG::Vertex_index((u + 1 + random.below(n - 1)) % n));
}

template <class Setting>
void take_back(Setting& setting)
{
  setting.network.clear();
  setting.triangulation.rollback();
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_CERTIFY_SECOND_OPINION_H
