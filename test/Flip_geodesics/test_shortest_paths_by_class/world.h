// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_SHORTEST_PATHS_BY_CLASS_WORLD_H
#define FLIP_GEODESICS_TEST_SHORTEST_PATHS_BY_CLASS_WORLD_H

#include "generated_curves.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

// Surfaces with obstacles and walls, and what is known of the ways around them.
namespace ways_test {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Filtered = CGAL::Face_filtered_graph<Surface>;
using Slit = FG::Slit_mesh<Filtered>;
using Vertex = Surface::Vertex_index;
using Halfedge = Slit::Halfedge;
using Curve = std::vector<FG::Curve_point<Slit, Point>>;
using Report = FG::Paths_by_class_report<Slit>;

// Are the ends of an edge two points between which there is a wall?
using Is_wall = bool (*)(const Point&, const Point&);

// A surface without the faces that are obstacles, and slit along walls.
struct World
{
  struct Wall_map
  {
    using key_type = Surface::Edge_index;
    using value_type = bool;
    using reference = bool;
    using category = boost::readable_property_map_tag;
    const Surface* mesh;
    Is_wall is_wall;
    friend bool get(const Wall_map& map, Surface::Edge_index e)
    {
      const auto h = map.mesh->halfedge(e);
      return map.is_wall(map.mesh->point(map.mesh->source(h)), map.mesh->point(map.mesh->target(h)));
    }
  };

  template <class IsObstacle>
  World(
      const Mesh_soup& soup, const IsObstacle& is_obstacle,
      Is_wall is_wall = [](const Point&, const Point&) { return false; })
    : mesh(to_mesh<Surface>(soup))
    , filtered(mesh, free_faces(is_obstacle))
    , slit(filtered, Wall_map{&mesh, is_wall})
  {
  }

  explicit World(const Mesh_soup& soup)
    : World(soup, [](std::size_t) { return false; })
  {
  }

  template <class IsObstacle>
  std::vector<Surface::Face_index> free_faces(const IsObstacle& is_obstacle) const
  {
    std::vector<Surface::Face_index> result;
    for(Surface::Face_index f : mesh.faces())
      if(!is_obstacle(static_cast<std::size_t>(f)))
        result.push_back(f);
    return result;
  }

  template <class... Options>
  auto paths(int source, int target, std::size_t number, std::vector<Curve>& out, const Options&... options) const
  {
    return FG::shortest_paths_by_class(slit, Vertex(static_cast<unsigned>(source)),
                                       Vertex(static_cast<unsigned>(target)), number, std::back_inserter(out),
                                       options...);
  }

  Surface mesh;
  Filtered filtered;
  Slit slit;
};

// The edges along which a curve can be moved with its ends held.
inline std::vector<Halfedge> edges_along(const Slit& mesh, const Curve& curve, Slit::Vertex start)
{
  std::vector<Halfedge> result;
  Slit::Vertex u = start;
  const auto move_to = [&](Slit::Vertex v) {
    if(u == v)
      return;
    const auto [h, is_edge] = halfedge(u, v, mesh);
    BOOST_TEST_REQUIRE(is_edge);
    result.push_back(h);
    u = v;
  };
  for(const auto& p : curve) {
    if(p.halfedge != Halfedge()) {
      move_to(source(p.halfedge, mesh));
      continue;
    }
    Halfedge corner = halfedge(p.location.first, mesh);
    Slit::Vertex v = source(corner, mesh);
    for(double weight : p.location.second) {
      if(weight == 1)
        v = source(corner, mesh);
      corner = next(corner, mesh);
    }
    move_to(v);
  }
  return result;
}

// Each curve has the ends and the length that are told, runs in its class, and no two run in one class.
inline void check_classes(const World& world, int source, int target, const std::vector<Curve>& curves,
                          const Report& report)
{
  using Triangulation = FG::Intrinsic_triangulation<Slit>;
  const Triangulation triangulation(world.slit);
  const FG::Loop_basis<Triangulation> basis(triangulation);
  const Vertex s(static_cast<unsigned>(source)), t(static_cast<unsigned>(target));
  std::vector<std::vector<Halfedge>> chains;
  const auto is_one_class = [&](const std::vector<Halfedge>& a, const std::vector<Halfedge>& b) {
    std::vector<FG::Input_halfedge_index> loop;
    for(Halfedge h : a)
      loop.push_back(triangulation.input().index(h));
    for(std::size_t i = b.size(); i-- > 0;)
      loop.push_back(triangulation.input().index(opposite(b[i], world.slit)));
    return basis.is_contractible(loop);
  };
  BOOST_TEST_REQUIRE(curves.size() == report.paths.size());
  BOOST_TEST_REQUIRE(curves.size() == report.classes.size());
  for(std::size_t i = 0; i < curves.size(); ++i) {
    BOOST_TEST(curves[i].front().point == world.mesh.point(s));
    BOOST_TEST(curves[i].back().point == world.mesh.point(t));
    double length = 0;
    for(std::size_t j = 1; j < curves[i].size(); ++j)
      length += std::sqrt(CGAL::squared_distance(curves[i][j - 1].point, curves[i][j].point));
    BOOST_TEST(std::abs(length - report.paths[i].length) < 1e-9 * length);
    BOOST_TEST(report.classes[i].length == report.paths[i].length);
    BOOST_TEST(report.paths[i].length <= report.classes[i].edge_length * (1 + 1e-12));
    BOOST_TEST((i == 0 || report.paths[i - 1].length <= report.paths[i].length));
    BOOST_TEST(is_one_class(edges_along(world.slit, curves[i], s), report.classes[i].edge_path));
    chains.push_back(report.classes[i].edge_path);
  }
  for(const auto& other : report.left_out)
    chains.push_back(other.edge_path);
  for(std::size_t i = 0; i < chains.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      BOOST_TEST(!is_one_class(chains[i], chains[j]));
}

inline void check_lengths(const Report& report, const std::vector<double>& expected)
{
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST((report.status == FG::Class_search_status::FOUND));
  BOOST_TEST_REQUIRE(report.paths.size() <= expected.size());
  for(std::size_t i = 0; i < report.paths.size(); ++i) {
    BOOST_TEST(std::abs(report.paths[i].length - expected[i]) < 1e-11 * expected[i]);
    BOOST_TEST((report.paths[i].shortening.curves[0].verdict == FG::Verdict::PROVEN));
  }
}

struct Place
{
  double x, y;
};

inline double distance(Place a, Place b) { return std::hypot(b.x - a.x, b.y - a.y); }

// A rectangle in the plane, and taut strings around it.
class Rectangle
{
public:
  Rectangle(double x0, double x1, double y0, double y1)
    : m_corner{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}
    , m_center{(x0 + x1) / 2, (y0 + y1) / 2}
  {
  }

  // Does a segment miss the inside?
  bool misses(Place a, Place b) const
  {
    double from = 0, to = 1;
    const auto clip = [&](double start, double step, double low, double high) {
      if(step == 0)
        return start > low && start < high;
      const double u = (low - start) / step, v = (high - start) / step;
      from = (std::max)(from, (std::min)(u, v));
      to = (std::min)(to, (std::max)(u, v));
      return true;
    };
    const bool is_between =
        clip(a.x, b.x - a.x, m_corner[0].x, m_corner[2].x) && clip(a.y, b.y - a.y, m_corner[0].y, m_corner[2].y);
    return !is_between || to - from < 1e-9;
  }

  // The lengths of the shortest paths between two places that go around different numbers of times, the shortest first.
  std::vector<double> lengths(Place s, Place t) const
  {
    std::map<int, double> shortest;
    const auto offer = [&](double turn, double length) {
      const int turns = static_cast<int>(std::lround((turn - turn_between(s, t)) / (2 * pi)));
      const auto place = shortest.emplace(turns, length).first;
      place->second = (std::min)(place->second, length);
    };
    if(misses(s, t))
      offer(turn_between(s, t), distance(s, t));
    for(int first = 0; first < 4; ++first)
      for(int step : {1, 3}) {
        double length = distance(s, m_corner[first]), turn = turn_between(s, m_corner[first]);
        for(int i = 0, c = first; i < 40 && misses(s, m_corner[first]); ++i, c = (c + step) % 4) {
          if(misses(m_corner[c], t))
            offer(turn + turn_between(m_corner[c], t), length + distance(m_corner[c], t));
          const Place next = m_corner[(c + step) % 4];
          length += distance(m_corner[c], next);
          turn += turn_between(m_corner[c], next);
        }
      }
    std::vector<double> result;
    for(const auto& entry : shortest)
      result.push_back(entry.second);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  double turn_between(Place a, Place b) const
  {
    return std::remainder(
        std::atan2(b.y - m_center.y, b.x - m_center.x) - std::atan2(a.y - m_center.y, a.x - m_center.x), 2 * pi);
  }

  Place m_corner[4];
  Place m_center;
};

} // namespace ways_test

#endif // FLIP_GEODESICS_TEST_SHORTEST_PATHS_BY_CLASS_WORLD_H
