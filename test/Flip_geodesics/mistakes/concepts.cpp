// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does not compile, since the triangulation or the network lacks a member of its concept.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>;
using Network = FG::Edge_path_network<Triangulation>;

template <class Base>
struct Incomplete : Base
{
  using Base::Base;
  void MEMBER(...) const = delete;
};

#ifdef OF_NETWORK
void use(Incomplete<Network>& network) { FG::shorten(network); }
#else
void use(Incomplete<Triangulation>& triangulation)
{
  FG::Edge_path_network<Incomplete<Triangulation>> network(triangulation);
}
#endif
