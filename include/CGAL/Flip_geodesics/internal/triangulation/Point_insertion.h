// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Insertion_editor.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_locator.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Word_path.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Can the traits lay out a part of an input face in their own numbers? */
template <class Traits, class = void>
struct Has_exact_subfaces : std::false_type
{
};

template <class Traits>
struct Has_exact_subfaces<Traits, std::void_t<typename Traits::Construct_subface>>
  : std::negation<std::is_void<typename Traits::Construct_subface>>
{
};

/* What has become of an edge that was split: its halfedge, which is shorter now, and the one that leads on from it. */
struct Edge_halves
{
  Halfedge_index first = null_index, second = null_index;
};

/*
 * Puts a new vertex x where a point was located: into a face, with three new edges, or onto an edge, with one new edge
 * for its other half and one into each of its faces.
 *
 *          o                    o
 *         /|.                  /|.            The words of the new edges come from the side's word: the input face of
 *        / | .                / | .           the point is a gap of it, so that the letters before the gap lead back
 *       /  |  .              /  |  .          to a and those after it on to b, and a turn about b within the face
 *      /  _x_  .            a---x---b         leads over to the word of bo.
 *     / /     . .            .  |  /
 *    a-----------b            . | /
 *                               p
 *
 * The triangulation's log has the record of the split already, so that an exception leaves nothing that could not be
 * taken back.
 */
template <class Triangulation, class Editor>
class Point_insertion
{
  using Traits = typename Triangulation::Traits;

  // A halfedge of the old triangulation and the gap of its word whose input face holds the point.
  struct Place
  {
    Halfedge_index h;
    std::size_t gap;
    Crossing_word word;

    Place reversed() const { return {Triangulation::twin(h), word.crossed.size() - gap, word.reversed()}; }
  };

public:
  Point_insertion(const Triangulation& triangulation, Editor& editor, const Located_point& located, Vertex_index x)
    : m_triangulation(triangulation)
    , m_editor(editor)
    , m_place{located.halfedge, located.gap, triangulation.crossing_word(located.halfedge)}
    , m_x(x)
  {
  }

  /* Splits the face on the left of the halfedge. */
  void split_face()
  {
    const Halfedge_index h = m_place.h, hn = next(h), hp = next(hn);
    const Crossing_word to_a = word_to_tail(m_place), to_b = word_to_head(m_place), to_o = word_to_apex(m_place);
    const Halfedge_index a = m_editor.add_edge(to_a), b = m_editor.add_edge(to_b), o = m_editor.add_edge(to_o);
    m_editor.link_face(h, twin(b), a);
    m_editor.link_face(hn, twin(o), b);
    m_editor.link_face(hp, twin(a), o);
    m_editor.set_outgoing(m_x, a);
    lay_out_faces({h, hn, hp});
  }

  /* Splits the edge of the halfedge. \pre its tail has not degree 1 within the face */
  Edge_halves split_edge()
  {
    const Halfedge_index h = m_place.h, t = twin(h);
    if(m_triangulation.is_border(t))
      return split_border_edge();
    return next(h) == t ? split_edge_to_degree_one() : split_inner_edge();
  }

private:
  static Halfedge_index twin(Halfedge_index h) { return Triangulation::twin(h); }
  Halfedge_index next(Halfedge_index h) const { return m_triangulation.next(h); }

  // ---------------------------------------------------------------- words

  // A path that starts at x in the input face of the gap.
  Word_path<Triangulation> path_from(const Place& place) const
  {
    const Input_halfedge_index face = Point_side<Triangulation>::face_of_gap(place.word, place.gap);
    return {m_triangulation, m_x, anchor(m_triangulation, m_x, face)};
  }

  Crossing_word word_to_head(const Place& place) const
  {
    Word_path<Triangulation> path = path_from(place);
    path.cross(place.word.crossed, place.gap, place.word.crossed.size());
    return path.finish(place.word.head, head_anchor(m_triangulation, place.word));
  }

  Crossing_word word_to_tail(const Place& place) const
  {
    Word_path<Triangulation> path = path_from(place);
    for(std::size_t i = place.gap; i-- > 0;)
      path.cross(twin_index(place.word.crossed[i]));
    return path.finish(place.word.tail, tail_anchor(m_triangulation, place.word));
  }

  // To the apex of the face on the left, over the head.
  Crossing_word word_to_apex(const Place& place) const
  {
    const Halfedge_index hn = next(place.h);
    const Crossing_word word = m_triangulation.crossing_word(hn);
    Word_path<Triangulation> path = path_over_head(place);
    path.cross(word.crossed, 0, word.crossed.size());
    return path.finish(word.head, head_anchor(m_triangulation, word));
  }

  // From x along the edge to its head, and about that through the face on the left.
  Word_path<Triangulation> path_over_head(const Place& place) const
  {
    const Halfedge_index hn = next(place.h);
    const auto number = [this](Halfedge_index h) { return m_triangulation.crossings(Triangulation::edge(h)); };
    const Index turns = Triangle_crossings(number(place.h), number(hn), number(next(hn))).emanating[2];
    Word_path<Triangulation> path = path_from(place);
    path.cross(place.word.crossed, place.gap, place.word.crossed.size());
    path.turn(place.word.head, head_anchor(m_triangulation, place.word), turns);
    return path;
  }

  // ---------------------------------------------------------------- connectivity

  // With h = a->b, which keeps its id from a to x.
  Edge_halves split_border_edge()
  {
    const Halfedge_index h = m_place.h, t = twin(h), hn = next(h), hp = next(hn);
    const Vertex_index b = m_triangulation.tail(t);
    const Crossing_word to_a = word_to_tail(m_place), to_b = word_to_head(m_place), to_o = word_to_apex(m_place);
    const Halfedge_index xb = m_editor.add_edge(to_b), xo = m_editor.add_edge(to_o);
    m_editor.shorten_edge(t, to_a);
    m_editor.put_on_border(twin(xb));
    m_editor.move_outgoing(b, t, twin(xb));
    m_editor.set_outgoing(m_x, xb);
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, hn, twin(xo));
    lay_out_faces({h, xb});
    return {h, xb};
  }

  Edge_halves split_inner_edge()
  {
    const Halfedge_index h = m_place.h, t = twin(h), hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const Vertex_index b = m_triangulation.tail(t);
    const Crossing_word to_a = word_to_tail(m_place), to_b = word_to_head(m_place), to_o = word_to_apex(m_place),
                        to_p = word_to_apex(m_place.reversed());
    const Halfedge_index xb = m_editor.add_edge(to_b), xo = m_editor.add_edge(to_o), xp = m_editor.add_edge(to_p);
    m_editor.shorten_edge(t, to_a);
    m_editor.move_outgoing(b, t, twin(xb));
    m_editor.set_outgoing(m_x, xb);
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, hn, twin(xo));
    m_editor.link_face(t, tn, twin(xp));
    m_editor.link_face(twin(xb), xp, tp);
    lay_out_faces({h, xb, t, twin(xb)});
    return {h, xb};
  }

  /*
   * The face of h = a->b is glued to itself along h and its twin, so that b has degree 1: both halves of the edge and a
   * loop from x about b, and one edge from x on the side of h to the face's corner after the twin.
   */
  Edge_halves split_edge_to_degree_one()
  {
    const Halfedge_index h = m_place.h, t = twin(h), hp = next(t);
    const Vertex_index b = m_triangulation.tail(t);
    const Place from_twin = m_place.reversed();
    const Crossing_word to_a = word_to_tail(m_place), to_b = word_to_head(m_place), to_o = word_to_apex(m_place);
    Word_path<Triangulation> loop = path_over_head(m_place);
    loop.cross(from_twin.word.crossed, 0, from_twin.gap);
    const Input_halfedge_index face = Point_side<Triangulation>::face_of_gap(from_twin.word, from_twin.gap);
    const Crossing_word around_b = loop.finish(m_x, anchor(m_triangulation, m_x, face));

    const Halfedge_index xb = m_editor.add_edge(to_b), xo = m_editor.add_edge(to_o), xx = m_editor.add_edge(around_b);
    m_editor.shorten_edge(t, to_a);
    m_editor.move_outgoing(b, t, twin(xb));
    m_editor.set_outgoing(m_x, xb);
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, twin(xb), twin(xx));
    m_editor.link_face(xx, t, twin(xo));
    lay_out_faces({h, xb, xx});
    return {h, xb};
  }

  // ---------------------------------------------------------------- geometry

  void lay_out_faces(std::initializer_list<Halfedge_index> halfedges)
  {
    for(Halfedge_index h : halfedges)
      lay_out(h);
  }

  void lay_out(Halfedge_index h)
  {
    const Halfedge_index hn = next(h), hp = next(hn);
    m_editor.lay_out(h, geometry_of_new_face({h, hn, hp}));
    for(Halfedge_index side : {h, hn, hp})
      if(!is_usable_length(m_triangulation.length(side)))
        fail("it is too close to a vertex");
  }

  typename Traits::Face_geometry geometry_of_new_face(const std::array<Halfedge_index, 3>& sides)
  {
    if constexpr(Has_exact_subfaces<Traits>::value) {
      return part_of_input_face(sides);
    } else {
      const auto geometry = fresh_face(m_triangulation, sides[0], Traits::Has_drift::value ? largest_angle_drift : 0);
      if(!geometry)
        fail("the flips of the triangulation were wrong by rounding");
      return *geometry;
    }
  }

  typename Traits::Face_geometry part_of_input_face(const std::array<Halfedge_index, 3>& sides)
  {
    for(Halfedge_index h : sides)
      if(m_triangulation.crossings(Triangulation::edge(h)) > 0)
        fail("an exact number type can express points only where no edge crosses an input edge yet");
    const Input_halfedge_index face =
        Point_side<Triangulation>::face_of_gap(m_triangulation.crossing_word(sides[0]), 0);
    std::array<std::array<double, 3>, 3> weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = vertex_weights(m_triangulation, m_triangulation.tail(sides[i]), face);
    const Traits& traits = m_triangulation.traits();
    return traits.construct_subface_object()(input_face_geometry(m_triangulation, face, traits), weights);
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    const Input_halfedge_index h = m_triangulation.location(m_x).halfedge;
    throw Insertion_error("a point in the face of halfedge " + std::to_string(h.idx()) +
                              " cannot be inserted: " + reason,
                          {static_cast<std::size_t>(h.idx())});
  }

  const Triangulation& m_triangulation;
  Editor& m_editor;
  Place m_place;
  Vertex_index m_x;
};

/* Makes a located point a vertex of a triangulation, of which there is an editor. If an edge is split, `on_split` gets
 * its halves; if that throws, it must have changed nothing. Then, and if anything else throws, nothing has changed. */
template <class Triangulation, class Editor, class OnSplit>
Vertex_index insert_point(Triangulation& triangulation, Editor editor, Located_point place,
                          const Surface_location& location, const OnSplit& on_split)
{
  const Halfedge_index t = Triangulation::twin(place.halfedge);
  const bool is_head_of_degree_one =
      place.is_on_edge && !triangulation.is_border(t) && triangulation.next(t) == place.halfedge;
  if(is_head_of_degree_one) // rather than the tail
    place = {t, (std::max)(triangulation.crossings(Triangulation::edge(t)), 0) - place.gap, true, null_index};
  const std::size_t start = triangulation.log_position();
  const Vertex_index x = editor.begin(place, location);
  try {
    Point_insertion<Triangulation, Editor> insertion(triangulation, editor, place, x);
    if(place.is_on_edge)
      on_split(insertion.split_edge());
    else
      insertion.split_face();
  } catch(...) {
    triangulation.rollback(start);
    throw;
  }
  return x;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H
