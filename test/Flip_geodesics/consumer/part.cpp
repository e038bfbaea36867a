// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Whether the package is found as a part of a project, with CGAL and what that is linked to; main.cpp takes longer.

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/Gmpq.h>

int main()
{
  const CGAL::Flip_geodesics::Vertex_index v(2);
  return CGAL::Gmpq(v.idx()) == CGAL::Gmpq(4, 2) ? 0 : 1;
}
