// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SQUARED_LENGTH_GEOMETRY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SQUARED_LENGTH_GEOMETRY_H

#include <CGAL/Flip_geodesics/internal/surface/Area_unit.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Squared lengths L, and S = 4 area of each face in units of the area unit. Flips stay in the field of the input's
 * numbers, and an edge's numbers are the same whatever flips led to it. For exact numbers only: in rounded ones L and S
 * drift apart, exponentially in the number of flips.
 *
 * A face's S is copied to its halfedges. A flip does not touch two of them that change their face; so S comes with a
 * generation, and of the copies in a face the one of the latest generation is right.
 */
template <class NT>
class Squared_length_geometry
{
public:
  using Vector_3 = std::array<NT, 3>;
  using Unit = Area_unit<NT>;

  struct Halfedge_geometry
  {
    NT squared_length, quadrupled_area;
    int generation;
  };

  struct Flipped_geometry
  {
    Halfedge_geometry h, t, tn, tp;
  };

  struct Corner
  {
    NT x, y;
  };

  using Face_geometry = std::array<Halfedge_geometry, 3>;

  static Face_geometry face(const Vector_3& u, const Vector_3& v, const Vector_3& w, const NT& quadrupled_area)
  {
    return face_from_squares(square(u), square(v), square(w), quadrupled_area);
  }

  static Face_geometry face_from_squares(const NT& a, const NT& b, const NT& c, const NT& quadrupled_area)
  {
    return {{{a, quadrupled_area, 0}, {b, quadrupled_area, 0}, {c, quadrupled_area, 0}}};
  }

  /* The corner at the head of `in` as a complex number, twice the product of the lengths: by the law of cosines. */
  static Corner corner(const Halfedge_geometry& in, const Halfedge_geometry& out, const Halfedge_geometry& opposite)
  {
    return {NT(in.squared_length + out.squared_length - opposite.squared_length), quadrupled_area(in, out, opposite)};
  }

  /*
   * With h = i->j of squared length L, k and l opposite, and x_k = (k - i).(j - i), x_l = (l - i).(j - i):
   * |kl|^2 = ((x_k - x_l)^2 + (S_ijk + S_jil)^2 / 4) / L, and S_ikl = (x_k S_jil + x_l S_ijk) / L.
   */
  static Flipped_geometry flip(const Unit& unit, const Halfedge_geometry& h, const Halfedge_geometry& hn,
                               const Halfedge_geometry& hp, const Halfedge_geometry& t, const Halfedge_geometry& tn,
                               const Halfedge_geometry& tp)
  {
    const NT half = NT(1) / NT(2);
    const NT& l = h.squared_length;
    const NT area_h = quadrupled_area(h, hn, hp), area_t = quadrupled_area(t, tn, tp), area = area_h + area_t;
    const NT x_k = (l + hp.squared_length - hn.squared_length) * half;
    const NT x_l = (l + tn.squared_length - tp.squared_length) * half;
    const NT along = x_k - x_l, across = area * half;
    const NT diagonal = (NT(along * along) + unit.product(across, across)) / l;
    const NT at_i = (x_k * area_t + x_l * area_h) / l, at_j = area - at_i;
    const int generation =
        1 + (std::max)({h.generation, hn.generation, hp.generation, t.generation, tn.generation, tp.generation});
    return {{diagonal, at_i, generation},
            {diagonal, at_j, generation},
            {tn.squared_length, at_i, generation},
            {tp.squared_length, at_j, generation}};
  }

  /* The triangle of three points, given by weights of the corners of a face, in the order of its halfedges' tails. */
  static Face_geometry subface(const Face_geometry& face, const std::array<std::array<double, 3>, 3>& weights)
  {
    std::array<std::array<NT, 3>, 3> p;
    for(int i = 0; i < 3; ++i) {
      const NT sum = NT(weights[i][0]) + NT(weights[i][1]) + NT(weights[i][2]);
      for(int k = 0; k < 3; ++k)
        p[i][k] = NT(weights[i][k]) / sum;
    }
    const auto square = [&](int from, int to) { // of the length, from barycentric differences
      const NT a = p[to][0] - p[from][0], b = p[to][1] - p[from][1], c = p[to][2] - p[from][2];
      return NT(-(NT(a * b) * face[0].squared_length + NT(b * c) * face[1].squared_length +
                  NT(c * a) * face[2].squared_length));
    };
    const NT determinant = p[0][0] * NT(p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                           p[0][1] * NT(p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                           p[0][2] * NT(p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    return face_from_squares(square(0, 1), square(1, 2), square(2, 0),
                             NT(determinant * quadrupled_area(face[0], face[1], face[2])));
  }

  static NT squared_length(const Halfedge_geometry& h) { return h.squared_length; }

private:
  static NT square(const Vector_3& v) { return NT(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

  static const NT& quadrupled_area(const Halfedge_geometry& a, const Halfedge_geometry& b, const Halfedge_geometry& c)
  {
    const Halfedge_geometry& later = a.generation >= b.generation ? a : b;
    return later.generation >= c.generation ? later.quadrupled_area : c.quadrupled_area;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SQUARED_LENGTH_GEOMETRY_H
