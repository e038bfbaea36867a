// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The names of enumerators, which the package keeps in the order of the enumerators. The switches have no default, so
// that the compiler finds an enumerator that is missing here.

#include <CGAL/Flip_geodesics.h>

#include <boost/test/unit_test.hpp>

#include <string>

namespace FG = CGAL::Flip_geodesics;

namespace {

#define NAME(enumeration, name)                                                                                        \
  case FG::enumeration::name:                                                                                          \
    return #name;

std::string spelling(FG::Verdict value)
{
  switch(value) {
    NAME(Verdict, PROVEN)
    NAME(Verdict, PROBABLE)
    NAME(Verdict, BENT_SEGMENT)
    NAME(Verdict, BENT_JOINT)
    NAME(Verdict, UNDECIDED)
    NAME(Verdict, WITHIN_ROUNDING)
    NAME(Verdict, WITHIN_TOLERANCE)
  }
  return {};
}

std::string spelling(FG::Shortening_status value)
{
  switch(value) {
    NAME(Shortening_status, LOCALLY_SHORTEST)
    NAME(Shortening_status, CONTRACTED)
    NAME(Shortening_status, LENGTH_LIMIT)
    NAME(Shortening_status, ANGLE_LIMIT)
    NAME(Shortening_status, ITERATION_LIMIT)
    NAME(Shortening_status, MEMORY_LIMIT)
    NAME(Shortening_status, STOPPED_BY_VISITOR)
    NAME(Shortening_status, PRECISION_LIMIT)
    NAME(Shortening_status, DEGENERATE_FACES)
  }
  return {};
}

std::string spelling(FG::Distance_field_status value)
{
  switch(value) {
    NAME(Distance_field_status, COMPLETE)
    NAME(Distance_field_status, RADIUS_REACHED)
    NAME(Distance_field_status, TARGETS_REACHED)
    NAME(Distance_field_status, WINDOW_LIMIT_REACHED)
    NAME(Distance_field_status, STOPPED_BY_VISITOR)
  }
  return {};
}

std::string spelling(FG::Class_search_status value)
{
  switch(value) {
    NAME(Class_search_status, FOUND)
    NAME(Class_search_status, NO_MORE_CLASSES)
    NAME(Class_search_status, COVERING_LIMIT)
    NAME(Class_search_status, STOPPED_BY_VISITOR)
  }
  return {};
}

std::string spelling(FG::Trace_status value)
{
  switch(value) {
    NAME(Trace_status, LENGTH)
    NAME(Trace_status, VERTEX)
    NAME(Trace_status, BORDER)
    NAME(Trace_status, CONSTRAINED_EDGE)
    NAME(Trace_status, CROSSING_LIMIT)
  }
  return {};
}

std::string spelling(FG::Mean_status value)
{
  switch(value) {
    NAME(Mean_status, CONVERGED)
    NAME(Mean_status, STUCK)
    NAME(Mean_status, ITERATION_LIMIT)
  }
  return {};
}

#undef NAME

// Also beyond the last enumerator.
template <class Enumeration>
void check_names()
{
  for(int i = 0; i < 16; ++i)
    BOOST_TEST(to_string(static_cast<Enumeration>(i)) == spelling(static_cast<Enumeration>(i)));
}

} // namespace

BOOST_AUTO_TEST_CASE(names_are_spelled_like_the_enumerators)
{
  check_names<FG::Verdict>();
  check_names<FG::Shortening_status>();
  check_names<FG::Distance_field_status>();
  check_names<FG::Class_search_status>();
  check_names<FG::Trace_status>();
  check_names<FG::Mean_status>();
}
