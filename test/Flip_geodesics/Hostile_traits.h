// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_HOSTILE_TRAITS_H
#define FLIP_GEODESICS_TEST_HOSTILE_TRAITS_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <functional>

/*
 * Traits whose decisions are wrong, as rounding can make those of doubles, but often and by much: every guard against
 * rounding has something to do.
 */
namespace Flip_geodesics_test {

/// What is said instead of the truth; empty functions are honest.
struct Lies
{
  std::function<bool(bool)> is_quad_reflex;         // may an edge not be flipped? Told what is true
  std::function<bool(int, bool)> is_wedge_straight; // of so many corners, told what is true
  std::function<bool(bool)> is_locally_delaunay;    // told what is true
  std::function<double(double)> length;             // told what is true
};

class Hostile_traits : public CGAL::Flip_geodesics::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>
{
  using Base = CGAL::Flip_geodesics::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;

public:
  explicit Hostile_traits(const Lies& lies = honest())
    : m_lies(&lies)
  {
  }

  // The turns about the far end of an edge that is to be flipped are asked about after two corners; wedges, after each.
  struct Turn : Base::Turn
  {
    int corners = 0;
    mutable bool is_wedge = false;
  };

  struct Extend_turn
  {
    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& opposite) const
    {
      Base::Extend_turn()(turn, in, out, opposite);
      ++turn.corners;
    }
  };

  struct Compare_turn_with_straight
  {
    CGAL::Uncertain<CGAL::Comparison_result> operator()(const Turn& turn) const
    {
      turn.is_wedge = turn.is_wedge || turn.corners != 2;
      bool result = turn.is_straight;
      if(turn.is_wedge && lies->is_wedge_straight)
        result = lies->is_wedge_straight(turn.corners, result);
      if(!turn.is_wedge && lies->is_quad_reflex)
        result = lies->is_quad_reflex(result);
      return result ? CGAL::LARGER : CGAL::SMALLER;
    }

    const Lies* lies;
  };

  struct Is_locally_delaunay
  {
    CGAL::Uncertain<bool> operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn,
                                     const Halfedge_geometry& hp, const Halfedge_geometry& t,
                                     const Halfedge_geometry& tn, const Halfedge_geometry& tp) const
    {
      const bool result = Base::Is_locally_delaunay()(h, hn, hp, t, tn, tp).make_certain();
      return lies->is_locally_delaunay ? lies->is_locally_delaunay(result) : result;
    }

    const Lies* lies;
  };

  struct Compute_length
  {
    double operator()(const Halfedge_geometry& h) const
    {
      const double result = Base::Compute_length()(h);
      return lies->length ? lies->length(result) : result;
    }

    const Lies* lies;
  };

  Extend_turn extend_turn_object() const { return {}; }
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {m_lies}; }
  Is_locally_delaunay is_locally_delaunay_object() const { return {m_lies}; }
  Compute_length compute_length_object() const { return {m_lies}; }

private:
  static const Lies& honest()
  {
    static const Lies none;
    return none;
  }

  const Lies* m_lies;
};

/// The opposite of what is true, once in `period` questions.
class Liar
{
public:
  explicit Liar(int period, int first = 0)
    : m_period(period)
    , m_count(first)
  {
  }

  bool operator()(bool truth) { return ++m_count % m_period == 0 ? !truth : truth; }

private:
  int m_period, m_count;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_HOSTILE_TRAITS_H
