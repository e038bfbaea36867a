// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LAST_LEGS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LAST_LEGS_H

#include <CGAL/Flip_geodesics/internal/distances/Field_query.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The last part of a shortest path that is straight: from the vertex at which it bends last, or from its source. */
struct Straight_leg
{
  Index root = null_index;    // where it starts, as in windows: a vertex, or a part of a source
  Input_halfedge_index first; // of the face in which it starts; at a vertex one that starts there
  Input_halfedge_index last;  // of the face in which it ends
  std::complex<double> start; // its direction at the start, of length 1, in the frame of `first`
  std::complex<double> end;   // from start to end, in the frame of `last`
};

/*
 * The last legs of shortest paths in a distance field from a point, without a walk along them. A window has the place
 * of its root in the frame of the edge that it crosses. How this frame is turned against one at the root is found from
 * the window on an edge before it, of which the root has the same place, and is kept. So each window is asked once, and
 * paths share what they have in common.
 *
 *     . root
 *      ' .
 *     +---'----+  the edge before it, side t1 of the face in which its rays come
 *      \    '. /
 *       \    '/    the edge of the window: the frame of h is turned against that of t1 by their angle
 *        '. /'.
 *          +    place
 *
 * Windows tell it only where no other path is as short within rounding; else there is no answer.
 */
template <class Triangulation>
class Last_legs
{
  using Query = Field_query<Triangulation>;
  using Propagation = Window_propagation<Triangulation>;

public:
  using Vector = std::complex<double>;

  /* \pre its sources are one point; it outlives this */
  explicit Last_legs(const Query& query)
    : m_query(query)
    , m_propagation(query.propagation())
    , m_input(query.triangulation().input())
  {
  }

  /* To a vertex that is reached, and no source. */
  std::optional<Straight_leg> operator()(Vertex_index v)
  {
    const Vertex_record& record = m_propagation.vertex(v);
    if(record.along != null_index)
      return along_edge(record);
    if(record.through == null_index)
      return inside_face(v, record.root);
    const Face_side f = sides().copy(record.through);
    return through_side(record.through, record.window, {f.x, f.y});
  }

  /* To a point of the face of h. */
  std::optional<Straight_leg> operator()(Input_halfedge_index h, const Face_weights& weights)
  {
    const typename Query::Arrival a = m_query(h, weights);
    if(a.root == null_index)
      return std::nullopt;
    if(a.through != null_index)
      return through_side(a.through, a.window,
                          position(sides().copy(a.through), m_query.turned(weights, h, a.through)));
    Input_halfedge_index first = h;
    while(!is_part(a.root) && m_input.tail(first).idx() != a.root)
      first = m_input.next(first);
    first = is_part(a.root) ? part(a.root).halfedge : first;
    const Face_side f = sides().copy(first);
    const Face_weights from = m_query.turned(m_query.from(a, h, weights), h, first);
    return straight(a.root, first, position(f, m_query.turned(weights, h, first)) - position(f, from));
  }

private:
  // How the frame of a window is turned against that of its root's face.
  struct Turn
  {
    Input_halfedge_index first = null_index; // of the root's face; null if it is not known
    Vector factor = 1;                       // takes directions there
  };

  // A window on the edge before another one: where it is kept, the side by which it enters the face, and how that is
  // turned; or the root itself.
  struct Before
  {
    std::uint64_t key = 0;
    Input_halfedge_index through = null_index; // null if the root is in the face
    Window window = {};                        // in the frame of that
    Turn turn;
    double error = 0; // how far the root is from where it should be
  };

  const auto& sides() const { return m_propagation.sides(); }
  bool is_part(Index root) const { return root >= m_input.number_of_vertices(); }
  const Source_part& part(Index root) const
  {
    return m_propagation.parts()[static_cast<std::size_t>(root - m_input.number_of_vertices())];
  }

  static std::optional<Straight_leg> straight(Index root, Input_halfedge_index h, const Vector& way)
  {
    const double length = std::abs(way);
    if(!(length > 0))
      return std::nullopt;
    return Straight_leg{root, h, h, way / length, way};
  }

  std::optional<Straight_leg> along_edge(const Vertex_record& record) const
  {
    if(!m_input.is_border(record.along))
      return straight(record.root, record.along, sides().copy(record.along).length);
    const Input_halfedge_index first = m_input.next(twin_index(record.along)); // starts at the root
    const Face_side f = sides().copy(first);
    return straight(record.root, first, {f.x, f.y});
  }

  // From a part of the source in a face to one of its corners.
  std::optional<Straight_leg> inside_face(Vertex_index v, Index root) const
  {
    Face_weights corner = {{1, 0, 0}};
    const Source_part& source = part(root);
    for(Input_halfedge_index h = source.halfedge; m_input.tail(h) != v; h = m_input.next(h))
      corner = {{corner[2], corner[0], corner[1]}};
    const Face_side f = sides().copy(source.halfedge);
    return straight(root, source.halfedge, position(f, corner) - position(f, source.ends[0]));
  }

  std::optional<Straight_leg> through_side(Input_halfedge_index through, const Window& w, const Vector& place)
  {
    const double crossing = w.crossing(place.real(), place.imag()),
                 equal = unfolded_place_error * (std::abs(crossing) + sides().copy(through).length);
    if(w.is_far || !(crossing >= w.from - equal && crossing <= w.to + equal))
      return std::nullopt;
    const Turn t = turn(through, w);
    const Vector way = place - Vector(w.x, -w.y);
    const Vector start = way * t.factor;
    if(t.first == null_index || !(std::abs(start) > 0))
      return std::nullopt;
    return Straight_leg{w.root, t.first, through, start / std::abs(start), way};
  }

  // Back over the edges that rays of the window cross, up to the root or a window whose turn is known.
  Turn turn(Input_halfedge_index through, const Window& w)
  {
    std::vector<std::pair<std::uint64_t, Vector>> steps; // keys of windows, and how the frame after each is turned
    Turn result;
    for(auto b = before(through, w); b; b = before(b->through, b->window)) {
      steps.emplace_back(b->key, b->turn.factor);
      if(b->through == null_index) {
        result.first = b->turn.first;
        break;
      }
      const auto [known, is_new] = m_turns.insert({b->key, Turn()}); // not known while it is looked for
      if(!is_new) {
        result = known->second;
        break;
      }
    }
    if(result.first == null_index)
      return result;
    for(std::size_t i = steps.size(); i-- > 0; result.factor *= steps[i].second)
      if(i + 1 < steps.size())
        m_turns[steps[i].first] = result;
    return result;
  }

  // What is nearest to the place of a window's root, in the face that its rays come from.
  std::optional<Before> before(Input_halfedge_index through, const Window& w) const
  {
    const Input_halfedge_index t = twin_index(through);
    const Face_side f = sides().copy(t);
    const Vector root(f.length - w.x, w.y); // in the frame of t
    std::optional<Before> best;
    see_root(t, f, w.root, root, best);
    const Vector apex(f.x, f.y);
    const Input_halfedge_index tn = f.next, tp = m_input.next(tn);
    see_windows(tn, f.length, apex - f.length, w.root, root, best);
    see_windows(tp, apex, -apex, w.root, root, best);
    if(best && !(best->error <= unfolded_place_error * (f.length + std::abs(root))))
      best.reset();
    return best;
  }

  static void note(const Before& b, std::optional<Before>& best)
  {
    if(!best || b.error < best->error)
      best = b;
  }

  void see_root(Input_halfedge_index t, const Face_side& f, Index root, const Vector& place,
                std::optional<Before>& best) const
  {
    Before b;
    const Input_halfedge_index tp = m_input.next(f.next);
    if(is_part(root)) {
      const Source_part& source = part(root);
      if(source.halfedge != t && source.halfedge != f.next && source.halfedge != tp)
        return;
      b.error = std::abs(place - position(f, m_query.turned(source.ends[0], source.halfedge, t)));
      b.turn = {t, -1};
    } else if(m_input.tail(tp).idx() == root) {
      const Vector apex(f.x, f.y);
      b.error = std::abs(place - apex);
      b.turn = {tp, std::abs(apex) / apex};
    } else
      return;
    note(b, best);
  }

  // The windows that enter the face by its side h, which starts at a point and has a direction.
  void see_windows(Input_halfedge_index h, const Vector& start, const Vector& direction, Index root,
                   const Vector& place, std::optional<Before>& best) const
  {
    const double length = std::abs(direction);
    const Vector factor = std::conj(direction) / length, in_frame = (place - start) * factor;
    std::uint64_t key = static_cast<std::uint64_t>(h.idx() / 2) << 32;
    for(Window w : m_propagation.windows().on_edge(h.idx() / 2)) {
      ++key;
      if(w.root != root || w.is_far || (w.side == 0) != is_first_side(h))
        continue;
      if(!is_first_side(h))
        w.mirror(length);
      note({key, h, w, {null_index, -factor}, std::abs(in_frame - Vector(w.x, -w.y))}, best);
    }
  }

  const Query m_query;
  const Propagation& m_propagation;
  const typename Triangulation::Input_mesh& m_input;
  std::unordered_map<std::uint64_t, Turn> m_turns; // of windows, by their edges and places there
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LAST_LEGS_H
