// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Face_chart.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Face_shape.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Refinement_outlook.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Segment_points.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Sharp_sectors.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Star_flips.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <queue>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Delaunay refinement [Chew 1993, Ruppert 1995, Shewchuk 1997] on an intrinsic triangulation [SSC19, section 4.3]: bad
 * faces, worst first, get a vertex at their circumcentre. If a constrained edge is in the way, or the vertex would see
 * one under an angle above 120 degrees, then that edge is split instead, and the vertex taken back by the log.
 *
 * Where the vertices that are allowed cannot suffice by far, the faces that ask for the most of them are given up, and
 * what is left is mended until it does not get less either.
 *
 * \tparam Splitter inserts points and splits edges: of a triangulation, or of a network with its curves
 * \tparam Visitor is asked before each face, and told of each flip and each vertex
 */
template <class Triangulation, class Splitter, class Visitor>
class Delaunay_refiner
{
  using Complex = std::complex<double>;

public:
  struct Limits
  {
    double smallest_angle; // radians
    double longest_edge;
    std::size_t insertions;
  };

  struct Counts
  {
    std::size_t splits = 0, refused = 0;
  };

  enum class End { NO_FACE_LEFT, LIMIT, VISITOR };

  Delaunay_refiner(Triangulation& triangulation, Splitter& splitter, const Limits& limits, Visitor& visitor)
    : m_triangulation(triangulation)
    , m_splitter(splitter)
    , m_visitor(visitor)
    , m_limits(limits)
    , m_star(triangulation)
    , m_is_in_sharp_sector(triangulation)
    , m_points(triangulation)
    , m_number_of_old_vertices(triangulation.number_of_vertices())
  {
  }

  /* Refines a triangulation that is constrained Delaunay. */
  End run()
  {
    for(Halfedge_index h : descriptors<Halfedge_index>(m_triangulation.number_of_halfedges()))
      if(!m_triangulation.is_border(h) && Shape::first_halfedge(m_triangulation, h) == h)
        look_at(h);
    while(!m_queue.empty()) {
      if(is_full())
        return End::LIMIT;
      if(m_outlook.is_hopeless(has_given_up() ? 0 : m_limits.insertions - number_of_new_vertices())) {
        if(has_given_up())
          break;
        give_up();
      }
      const Bad_face bad = take_worst();
      if(is_given_up(bad.lengths) || !is_current(bad))
        continue;
      if(!m_visitor.go_further())
        return End::VISITOR;
      if(improve(bad.halfedge))
        look_at(bad.halfedge); // still bad if only an edge was split
      else
        ++m_counts.refused;
    }
    return End::NO_FACE_LEFT;
  }

  const Counts& counts() const { return m_counts; }

  /* The number of flips, those taken back included. */
  std::size_t flips() const { return m_star.flips(); }

  /* The vertices inside faces and on constrained edges. */
  std::size_t number_of_new_vertices() const
  {
    return static_cast<std::size_t>(m_triangulation.number_of_vertices() - m_number_of_old_vertices);
  }

  /*
   * How bad a face is; 0 if it is good or exempt. A small angle is no reason where no insertion could mend it: between
   * constrained edges that meet under less than 60 degrees, or about a vertex with less than that in all; also where
   * the shortest side spans such an angle between points at equal distances from the vertex [Shewchuk 2002].
   */
  double badness(Halfedge_index h)
  {
    const Shape shape(m_triangulation, h);
    if(is_too_long(shape.lengths()))
      return 2 + shape.longest() / m_limits.longest_edge;
    const double angle = shape.smallest_angle();
    return angle < m_limits.smallest_angle && !is_exempt(shape) ? 2 - angle / m_limits.smallest_angle : 0;
  }

  bool is_exempt(Halfedge_index h) { return is_exempt(Shape(m_triangulation, h)); }

  /* Was a bad face left as it is since the vertices that are allowed cannot suffice? */
  bool is_given_up(Halfedge_index h) const { return is_given_up(Shape(m_triangulation, h).lengths()); }

private:
  using Shape = Face_shape<Triangulation>;
  using Lengths = std::array<double, 3>;

  struct Bad_face
  {
    double badness, need;
    Halfedge_index halfedge; // the smallest of the face
    Lengths lengths;

    bool operator<(const Bad_face& other) const
    {
      return badness != other.badness ? badness < other.badness : halfedge > other.halfedge;
    }
  };

  // ---------------------------------------------------------------- the queue

  void look_at(Halfedge_index h)
  {
    if(m_triangulation.is_border(h))
      return;
    const Halfedge_index first = Shape::first_halfedge(m_triangulation, h);
    const double how_bad = badness(first);
    if(how_bad <= 0)
      return;
    const Shape shape(m_triangulation, first);
    if(is_given_up(shape.lengths()))
      return;
    m_queue.push({how_bad, need(shape), first, shape.lengths()});
    m_outlook.add(need(shape));
  }

  Bad_face take_worst()
  {
    const Bad_face worst = m_queue.top();
    m_queue.pop();
    m_outlook.remove(worst.need);
    return worst;
  }

  bool is_full() const { return number_of_new_vertices() >= m_limits.insertions; }

  // What a thin face asks for, as the outlook sees it.
  double need(const Shape& shape) const
  {
    return is_too_long(shape.lengths()) ? 0
                                        : Refinement_outlook::need(shape.lengths(), std::sin(shape.smallest_angle()));
  }

  bool is_too_long(const Lengths& lengths) const
  {
    return *std::max_element(lengths.begin(), lengths.end()) > m_limits.longest_edge;
  }

  bool has_given_up() const { return m_finest_side > 0; }

  bool is_given_up(const Lengths& lengths) const
  {
    return *std::min_element(lengths.begin(), lengths.end()) <= m_finest_side && !is_too_long(lengths);
  }

  // By the sides of the faces that need the most: so small ones are not mended, here or elsewhere, or else those faces
  // would be taken up bit by bit from their ends.
  void give_up()
  {
    const double many = m_outlook.mean_need() / 2;
    for(Halfedge_index h : descriptors<Halfedge_index>(m_triangulation.number_of_halfedges())) {
      if(m_triangulation.is_border(h) || Shape::first_halfedge(m_triangulation, h) != h || !(badness(h) > 0))
        continue;
      const Shape shape(m_triangulation, h);
      if(need(shape) >= many)
        m_finest_side = (std::max)(m_finest_side, shape.shortest());
    }
  }

  // Is the face still there?
  bool is_current(const Bad_face& bad) const
  {
    if(bad.halfedge.idx() >= m_triangulation.number_of_halfedges() || m_triangulation.is_border(bad.halfedge))
      return false;
    if(Shape::first_halfedge(m_triangulation, bad.halfedge) != bad.halfedge)
      return false;
    const std::array<double, 3> lengths = Shape(m_triangulation, bad.halfedge).lengths();
    for(int i = 0; i < 3; ++i) // a face may have been laid out afresh
      if(std::abs(lengths[i] - bad.lengths[i]) > same_shape * bad.lengths[i])
        return false;
    return true;
  }

  bool is_exempt(const Shape& shape)
  {
    return m_is_in_sharp_sector(shape.spoke_of_smallest_corner()) || m_points.spans_small_angle(shape.shortest_side());
  }

  // ---------------------------------------------------------------- one face

  // The face on the left of `halfedge`, from its tail at the origin and its head on the real axis, has the point.
  struct Place
  {
    Halfedge_index halfedge;
    Complex point;
    bool is_blocked; // by the edge of the halfedge
  };

  bool improve(Halfedge_index h)
  {
    const std::optional<Place> center = walk_to_circumcenter(h);
    if(!center)
      return false;
    if(center->is_blocked)
      return split(center->halfedge);
    const auto before = m_triangulation.log_position();
    const Vertex_index x = insert(*center);
    if(x == null_index)
      return false;
    const bool is_removable = !is_on_constrained_edge(x), are_flips_right = m_star.flip_around(x, m_visitor);
    std::vector<Edge_index> encroached;
    if(is_removable && are_flips_right)
      encroached = encroached_by(x);
    if(!encroached.empty() || (is_removable && !are_flips_right)) {
      m_triangulation.rollback(before);
      return split_all(encroached);
    }
    look_around(x);
    m_visitor.on_insertion(m_triangulation, x);
    return true;
  }

  // A new vertex; null where numbers are too coarse, or one is there already. Points are found from corners of their
  // input faces, as if each were inserted by itself, until that costs too much.
  Vertex_index insert(const Place& center)
  {
    constexpr std::size_t letters_per_point = 512;
    const Vertex_index wanted(m_triangulation.number_of_vertices());
    try {
      const auto place = Face_chart<Triangulation>(m_triangulation, center.halfedge).locate(center.point);
      if(!place || !has_room(place->location, std::abs(center.point)))
        return null_index;
      Known_piece close_by = {place->halfedge, place->gap, m_letters + letters_per_point};
      const Vertex_index x = m_splitter.insert(place->location, &close_by);
      m_letters = close_by.letters;
      return x == wanted ? x : null_index;
    } catch(const Insertion_error&) {
      return null_index;
    }
  }

  // The point was exactly there: then the edge was split, and with it a curve.
  bool is_on_constrained_edge(Vertex_index x) const
  {
    bool result = false;
    for_each_edge_in_star(m_triangulation, x, [&](Halfedge_index h) {
      const bool is_spoke = m_triangulation.tail(h) == x || m_triangulation.head(h) == x;
      result = result || (is_spoke && is_constrained(h));
    });
    return result;
  }

  // Are weights in the input face fine enough for edges as short as `distance`?
  bool has_room(const Surface_location& location, double distance) const
  {
    double longest = 0;
    Input_halfedge_index h = location.halfedge;
    for(int i = 0; i < 3; ++i, h = m_triangulation.input().next(h))
      longest = (std::max)(longest, m_triangulation.metric().length(m_triangulation.input(), h));
    return distance > least_point_spacing * longest;
  }

  std::optional<Place> walk_to_circumcenter(Halfedge_index h) const
  {
    constexpr int most_steps = 100000;
    std::array<Complex, 3> p = laid_out(h, 0, m_triangulation.length(h));
    const Complex start = (p[0] + p[1] + p[2]) / 3.0;
    const std::optional<Complex> center = circumcenter(p);
    if(!center)
      return {};
    for(int i = 0; i < 3 && is_left(p[0], p[1], *center); ++i) { // turn to the side where the way leaves the first face
      h = m_triangulation.next(h);
      p = {p[1], p[2], p[0]};
    }
    // Of two sides that the centre is beyond, the way crosses one.
    if(!is_left(p[0], p[1], *center) && !is_between(start, *center, p[0], p[1])) {
      const bool is_next = !is_left(p[1], p[2], *center);
      h = is_next ? m_triangulation.next(h) : m_triangulation.previous(h);
      p = is_next ? std::array<Complex, 3>{p[1], p[2], p[0]} : std::array<Complex, 3>{p[2], p[0], p[1]};
    }
    for(int step = 0; step < most_steps; ++step) {
      if(is_left(p[0], p[1], *center))
        return Place{h, (*center - p[0]) * std::abs(p[1] - p[0]) / (p[1] - p[0]), false};
      if(is_constrained(h))
        return Place{h, 0, true};
      h = Triangulation::twin(h);
      p = laid_out(h, p[1], p[0]);
      const bool is_inside = is_left(p[1], p[2], *center) && is_left(p[2], p[0], *center);
      if(is_inside)
        continue; // the next step returns, for the centre is on the left of h as well
      const bool is_apex_left = is_left(start, *center, p[2]);
      h = is_apex_left ? m_triangulation.next(h) : m_triangulation.previous(h);
      p = is_apex_left ? std::array<Complex, 3>{p[1], p[2], p[0]} : std::array<Complex, 3>{p[2], p[0], p[1]};
    }
    return {};
  }

  std::array<Complex, 3> laid_out(Halfedge_index h, const Complex& tail, const Complex& head) const
  {
    const Halfedge_index hn = m_triangulation.next(h);
    return {tail, head,
            apex_of(tail, head, m_triangulation.length(hn), m_triangulation.length(m_triangulation.next(hn)))};
  }

  static bool is_left(const Complex& p, const Complex& q, const Complex& z) { return cross(q - p, z - p) >= 0; }
  static bool is_between(const Complex& from, const Complex& to, const Complex& p, const Complex& q)
  {
    return !is_left(from, to, p) && is_left(from, to, q);
  }

  static std::optional<Complex> circumcenter(const std::array<Complex, 3>& p)
  {
    const Complex b = p[1] - p[0], c = p[2] - p[0];
    const Complex center = Complex(0, 1) * (b * std::norm(c) - c * std::norm(b)) / (2 * cross(b, c));
    if(!std::isfinite(center.real()) || !std::isfinite(center.imag()))
      return {};
    return p[0] + center;
  }

  // ---------------------------------------------------------------- splits and flips

  bool is_constrained(Halfedge_index h) const { return is_constrained_edge(m_triangulation, h); }

  bool split(Halfedge_index h)
  {
    if(m_triangulation.is_border(h))
      h = Triangulation::twin(h);
    const double t = split_position(h);
    const auto in_segment = m_points.point(h, t * m_triangulation.length(h));
    Vertex_index x = null_index;
    try {
      const std::optional<Point_on_edge> point = point_on_edge(m_triangulation, h, t);
      if(!point || !has_room(point->location, (std::min)(t, 1 - t) * m_triangulation.length(h)))
        return false;
      x = m_splitter.split_edge(h, point->location, point->gap);
    } catch(const Insertion_error&) {
      return false;
    }
    m_points.add(x, in_segment);
    ++m_counts.splits;
    m_star.flip_around(x, m_visitor);
    look_around(x);
    m_visitor.on_insertion(m_triangulation, x);
    return true;
  }

  /*
   * In the middle; but if one end is an old vertex, at a power of two from it, so that constrained edges that meet
   * there are split at equal distances and their halves do not go on encroaching on one another [Ruppert 1995].
   */
  double split_position(Halfedge_index h) const
  {
    const bool is_tail_old = m_triangulation.tail(h).idx() < m_number_of_old_vertices;
    const bool is_head_old = m_triangulation.head(h).idx() < m_number_of_old_vertices;
    if(is_tail_old == is_head_old)
      return 0.5;
    const double length = m_triangulation.length(h);
    const double t = std::exp2(std::round(std::log2(length / 2))) / length;
    return is_tail_old ? t : 1 - t;
  }

  // Of edges; is one split?
  bool split_all(const std::vector<Edge_index>& edges)
  {
    bool result = false;
    for(Edge_index e : edges)
      result = (!is_full() && split(first_side(e))) || result;
    return result;
  }

  // The constrained edges that vertex x sees under more than 120 degrees.
  std::vector<Edge_index> encroached_by(Vertex_index x) const
  {
    std::vector<Edge_index> encroached;
    for_each_edge_in_star(m_triangulation, x, [&](Halfedge_index h) {
      const bool is_opposite = !m_triangulation.is_border(h) && m_triangulation.tail(h) != x &&
                               m_triangulation.head(h) != x && is_constrained(h);
      if(is_opposite && Shape(m_triangulation, h).cosine_opposite() < -0.5)
        encroached.push_back(Triangulation::edge(h));
    });
    return encroached;
  }

  void look_around(Vertex_index x)
  {
    std::vector<Halfedge_index> around;
    for_each_edge_in_star(m_triangulation, x, [&around](Halfedge_index h) { around.push_back(h); });
    for(Halfedge_index h : m_star.flipped())
      around.insert(around.end(), {h, Triangulation::twin(h)});
    for(Halfedge_index& h : around)
      h = m_triangulation.is_border(h) ? null_index : Shape::first_halfedge(m_triangulation, h);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for(Halfedge_index h : around)
      if(h != null_index)
        look_at(h);
  }

  Triangulation& m_triangulation;
  Splitter& m_splitter;
  Visitor& m_visitor;
  Limits m_limits;
  Star_flips<Triangulation> m_star;
  Sharp_sectors<Triangulation> m_is_in_sharp_sector;
  Segment_points<Triangulation> m_points;
  Refinement_outlook m_outlook;
  double m_finest_side = 0;         // thin faces with a side no longer than that are given up
  std::size_t m_letters = 0x200000; // that the search for points may pass
  Index m_number_of_old_vertices;
  std::priority_queue<Bad_face> m_queue;
  Counts m_counts;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H
