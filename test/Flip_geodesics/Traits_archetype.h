// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_TRAITS_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_TRAITS_ARCHETYPE_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Flip_geodesics_test {

/*
 * The least that `IntrinsicTriangulationTraits` asks for, and another geometry than the library's: a halfedge stores
 * its length and nothing else, in long double, and angles come from the law of cosines.
 *
 * Its numbers convert to nothing, and copying them is not trivial, so that whatever the library does with them other
 * than to hand them on does not compile.
 */
class Traits_archetype
{
  class Number
  {
  public:
    Number() = default;
    explicit Number(long double value)
      : m_value(value)
    {
    }
    Number(const Number& other)
      : m_value(other.m_value)
    {
    }
    Number& operator=(const Number& other)
    {
      m_value = other.m_value;
      return *this;
    }
    ~Number() {}
    long double value() const { return m_value; }

  private:
    long double m_value = 0;
  };

public:
  using FT = Number;
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  using Has_drift = CGAL::Tag_true;

  class Halfedge_geometry
  {
  public:
    Halfedge_geometry() = default;

  private:
    friend class Traits_archetype;
    explicit Halfedge_geometry(long double length)
      : m_length(length)
    {
    }
    long double length() const { return m_length.value(); }

    Number m_length;
  };

  class Face_geometry
  {
  public:
    const Halfedge_geometry& operator[](std::size_t i) const { return m_sides[i]; }

  private:
    friend class Traits_archetype;
    Face_geometry(long double a, long double b, long double c)
      : m_sides{Halfedge_geometry(a), Halfedge_geometry(b), Halfedge_geometry(c)}
    {
    }

    std::array<Halfedge_geometry, 3> m_sides;
  };

  class Turn
  {
  public:
    Turn() = default;

  private:
    friend class Traits_archetype;
    long double m_angle = 0;
  };

  struct Flipped_geometry
  {
    Halfedge_geometry h, t, tn, tp;
  };

  struct Construct_face_3
  {
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      return Face_geometry(distance(p, q), distance(q, r), distance(r, p));
    }
  };

  struct Construct_face_from_lengths
  {
    Face_geometry operator()(double a, double b, double c) const { return Face_geometry(a, b, c); }
  };

  struct Construct_face_2
  {
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double /* error */) const
    {
      return Face_geometry(norm(v[0]), norm(v[1]), norm(v[2]));
    }
  };

  struct Is_inaccurate
  {
    bool operator()(const Halfedge_geometry&) const { return false; }
  };

  struct Extend_turn
  {
    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& opposite) const
    {
      turn.m_angle += angle(in.length(), out.length(), opposite.length());
    }
  };

  struct Compare_turn_with_straight
  {
    CGAL::Uncertain<CGAL::Comparison_result> operator()(const Turn& turn) const
    {
      return turn.m_angle < pi() - 1e-9L ? CGAL::SMALLER : CGAL::LARGER;
    }
  };

  struct Turn_key
  {
    double operator()(const Turn& turn) const
    {
      const long double x = std::cos(turn.m_angle), y = std::sin(turn.m_angle);
      return static_cast<double>(1 - x / (std::abs(x) + y));
    }
  };

  struct Flip
  {
    Flipped_geometry operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                                const Halfedge_geometry& t, const Halfedge_geometry& tn,
                                const Halfedge_geometry& tp) const
    {
      const long double at_tail =
          angle(h.length(), hp.length(), hn.length()) + angle(t.length(), tn.length(), tp.length());
      const long double half = std::sin(at_tail / 2), difference = hp.length() - tn.length();
      const Halfedge_geometry diagonal(
          std::sqrt(difference * difference + 4 * hp.length() * tn.length() * half * half));
      return {diagonal, diagonal, tn, tp};
    }
  };

  struct Is_locally_delaunay
  {
    CGAL::Uncertain<bool> operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn,
                                     const Halfedge_geometry& hp, const Halfedge_geometry& t,
                                     const Halfedge_geometry& tn, const Halfedge_geometry& tp) const
    {
      return angle(hn.length(), hp.length(), h.length()) + angle(tn.length(), tp.length(), t.length()) <= pi() + 1e-9L;
    }
  };

  struct Compute_squared_length
  {
    FT operator()(const Halfedge_geometry& h) const { return FT(h.length() * h.length()); }
  };

  struct Compute_length
  {
    double operator()(const Halfedge_geometry& h) const { return static_cast<double>(h.length()); }
  };

  Construct_face_3 construct_face_3_object() const { return {}; }
  Construct_face_from_lengths construct_face_from_lengths_object() const { return {}; }
  Construct_face_2 construct_face_2_object() const { return {}; }
  Is_inaccurate is_inaccurate_object() const { return {}; }
  Extend_turn extend_turn_object() const { return {}; }
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {}; }
  Turn_key turn_key_object() const { return {}; }
  Flip flip_object() const { return {}; }
  Is_locally_delaunay is_locally_delaunay_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return {}; }
  Compute_length compute_length_object() const { return {}; }

private:
  static long double pi() { return 3.14159265358979323846264338327950288L; }

  // Between sides a and b, opposite c [K14].
  static long double angle(long double a, long double b, long double c)
  {
    const long double longer = (std::max)(a, b), shorter = (std::min)(a, b);
    const long double mu = shorter >= c ? c - (longer - shorter) : shorter - (longer - c);
    const long double numerator = ((longer - shorter) + c) * (std::max)(mu, 0.0L);
    const long double denominator = (longer + (shorter + c)) * ((longer - c) + shorter);
    return denominator > 0 ? 2 * std::atan(std::sqrt(numerator / denominator)) : pi();
  }

  static long double distance(const Point_3& p, const Point_3& q)
  {
    const long double x = q.x() - static_cast<long double>(p.x()), y = q.y() - static_cast<long double>(p.y()),
                      z = q.z() - static_cast<long double>(p.z());
    return std::sqrt(x * x + y * y + z * z);
  }

  static long double norm(const std::array<double, 2>& v) { return std::hypot((long double)v[0], (long double)v[1]); }
};

/*
 * Adds the optional overloads of the functors that lay out faces. Each reports its call; faces from points are not
 * expected for exact coordinates, and have no definition.
 */
class Traits_with_exact_faces : public Traits_archetype
{
public:
  using Point_3 = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  using Integer =
      boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

  static inline int faces_from_sides = 0, faces_from_squares = 0;

  struct Construct_face_3
  {
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const;

    Face_geometry operator()(const std::array<std::array<double, 3>, 3>& sides) const
    {
      ++faces_from_sides;
      const auto length = [&](int i) { return std::hypot(sides[i][0], sides[i][1], sides[i][2]); };
      return Traits_archetype::Construct_face_from_lengths()(length(0), length(1), length(2));
    }
  };

  struct Construct_face_from_lengths
  {
    Face_geometry operator()(double a, double b, double c) const;

    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const
    {
      ++faces_from_squares;
      const auto length = [&](int i) {
        return std::sqrt(static_cast<double>(squares[i]) / static_cast<double>(denominator));
      };
      return Traits_archetype::Construct_face_from_lengths()(length(0), length(1), length(2));
    }
  };

  Construct_face_3 construct_face_3_object() const { return {}; }
  Construct_face_from_lengths construct_face_from_lengths_object() const { return {}; }
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_TRAITS_ARCHETYPE_H
