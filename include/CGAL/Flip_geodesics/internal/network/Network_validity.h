// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_VALIDITY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_VALIDITY_H

#include <CGAL/Flip_geodesics/Joint.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The invariant of Edge_path_network, checked through its public members alone. */
template <class Network>
class Network_validity
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Network_validity(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  bool is_valid() const
  {
    if(!has_valid_chains())
      return false;
    for(Segment_index s(1); s.idx() < m_network.end_of_segment_ids(); ++s)
      if(m_network.is_alive(s) && !(is_non_crossing_at({m_network.halfedge(s), s}) &&
                                    is_non_crossing_at({Triangulation::twin(m_network.halfedge(s)), s})))
        return false;
    return true;
  }

  /* Are the curves chains, and the stacks those of their edges? Curves may cross. */
  bool has_valid_chains() const
  {
    for(Curve_index c : descriptors<Curve_index>(m_network.number_of_curves()))
      if(!is_valid_chain(c))
        return false;
    for(Segment_index s(1); s.idx() < m_network.end_of_segment_ids(); ++s)
      if(m_network.is_alive(s) && !is_valid_stack(s))
        return false;
    return true;
  }

  bool is_non_crossing_at(const Strand_end& end) const
  {
    Strand_end start = end;
    bool has_border = false;
    for(Strand_end e = m_network.next_beyond_others(start, Side::LEFT); e != end;
        e = m_network.next_beyond_others(start, Side::LEFT))
    {
      if(e.is_none()) {
        has_border = true;
        break;
      }
      start = e;
    }
    return is_non_crossing_from(has_border ? start : end, has_border);
  }

private:
  bool is_valid_chain(Curve_index curve) const
  {
    bool is_chain = true;
    Segment_index last = null_index;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      is_chain = is_chain && m_network.is_alive(s) && m_network.curve(s) == curve;
      const Segment_index t = m_network.next(s);
      is_chain = is_chain &&
                 (t == null_index || (m_network.previous(t) == s && m_triangulation.head(m_network.halfedge(s)) ==
                                                                        m_triangulation.tail(m_network.halfedge(t))));
      last = s;
    });
    return is_chain && last == m_network.last_segment(curve) &&
           (last == null_index || (m_network.next(last) == null_index) != m_network.is_closed(curve));
  }

  bool is_valid_stack(Segment_index s) const
  {
    const Edge_index e = Triangulation::edge(m_network.halfedge(s));
    const std::vector<Segment_index> stack = m_network.stack(e);
    for(Segment_index t : stack)
      if(!m_network.is_alive(t) || Triangulation::edge(m_network.halfedge(t)) != e)
        return false;
    return std::find(stack.begin(), stack.end(), s) != stack.end() &&
           m_network.outermost(first_side(e), Side::LEFT) == stack.front() &&
           m_network.outermost(first_side(e), Side::RIGHT) == stack.back();
  }

  // The end that a joint, if not fixed, connects with this one.
  Strand_end partner(const Strand_end& end) const
  {
    const Segment_index s = end.segment;
    if(end.halfedge == m_network.halfedge(s)) {
      const Segment_index p = m_network.previous(s);
      return p == null_index || m_network.is_head_fixed(p) ? Strand_end{}
                                                           : Strand_end{Triangulation::twin(m_network.halfedge(p)), p};
    }
    return m_network.is_head_fixed(s) ? Strand_end{}
                                      : Strand_end{m_network.halfedge(m_network.next(s)), m_network.next(s)};
  }

  // Clockwise from an end, which comes first after the border if there is one: matched ends nest like brackets, and
  // single ends, like the border, all lie at one depth outside every bracket, or inside one and the same.
  bool is_non_crossing_from(const Strand_end& start, bool has_border) const
  {
    std::vector<Strand_end> open;
    Strand_end region; // the innermost open bracket around the single ends
    bool has_region = has_border;
    Strand_end end = start;
    do {
      const Strand_end mate = partner(end);
      if(mate.is_none()) {
        const Strand_end here = open.empty() ? Strand_end{} : open.back();
        if(has_region && region != here)
          return false;
        region = here;
        has_region = true;
      } else if(!open.empty() && open.back() == mate) {
        open.pop_back();
      } else {
        open.push_back(end);
      }
      end = m_network.next_beyond_others(end, Side::RIGHT);
    } while(!end.is_none() && end != start);
    return open.empty();
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_VALIDITY_H
