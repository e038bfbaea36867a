// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NETWORK_PLACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NETWORK_PLACE_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <string>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

class Network_claim;

/*
 * The place for a network in a triangulation, which has one: two would write the same labels. The network refers to the
 * triangulation, so that neither may move while it is taken.
 */
class Network_place
{
public:
  Network_place() = default;
  Network_place(Network_place&& other) { other.check_vacant("moved"); }
  Network_place& operator=(Network_place&& other)
  {
    check_vacant("assigned to");
    other.check_vacant("moved");
    return *this;
  }
  ~Network_place();

  bool is_taken() const { return m_claim != nullptr; }
  bool has_curves() const;

  void check_vacant(const std::string& what_is_done) const
  {
    if(is_taken())
      throw Occupied_triangulation_error("a triangulation that a network lives in cannot be " + what_is_done);
  }

private:
  friend class Network_claim;

  Network_claim* m_claim = nullptr;
};

/* For a network that comes and goes while one without curves waits. */
struct Beside_empty_network
{
};

/* For a network that comes and goes while the labels of one with curves are lifted from the edges. */
struct Beside_lifted_network
{
};

/* A network's claim to the place; it lapses if the triangulation goes first. */
class Network_claim
{
public:
  explicit Network_claim(Network_place& place)
    : m_place(&place)
  {
    place.check_vacant("given another one");
    place.m_claim = this;
  }

  Network_claim(Network_place& place, Beside_empty_network)
    : m_place(&place)
    , m_waiting(place.m_claim)
  {
    if(place.has_curves())
      place.check_vacant("given another one");
    place.m_claim = this;
  }

  Network_claim(Network_place& place, Beside_lifted_network)
    : m_place(&place)
    , m_waiting(place.m_claim)
  {
    place.m_claim = this;
  }

  Network_claim(const Network_claim&) = delete;
  Network_claim& operator=(const Network_claim&) = delete;

  ~Network_claim()
  {
    if(m_place != nullptr)
      m_place->m_claim = m_waiting;
  }

  bool has_lapsed() const { return m_place == nullptr; }
  bool has_curves() const { return m_has_curves; }
  void set_has_curves(bool has_curves) { m_has_curves = has_curves; }

private:
  friend class Network_place;

  Network_place* m_place;
  Network_claim* m_waiting = nullptr;
  bool m_has_curves = false;
};

inline Network_place::~Network_place()
{
  if(m_claim != nullptr)
    m_claim->m_place = nullptr;
}

inline bool Network_place::has_curves() const { return m_claim != nullptr && m_claim->has_curves(); }

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NETWORK_PLACE_H
