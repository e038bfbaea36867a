// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CROSSING_WORDS_H
#define CGAL_FLIP_GEODESICS_CROSSING_WORDS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>

namespace CGAL {
namespace Flip_geodesics {

template <class Triangulation>
class Crossing_words
{
public:
  explicit Crossing_words(const Triangulation& triangulation)
    : m_triangulation(&triangulation)
  {
  }
  Crossing_word operator()(Index h) const { return m_triangulation->crossing_word(h); }

private:
  const Triangulation* m_triangulation;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CROSSING_WORDS_H
