// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does not compile, since the traits, the metric, the triangulation or the network lack a member of its concept.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace FG = CGAL::Flip_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

template <class Base>
struct Incomplete : Base
{
  using Base::Base;
  void MEMBER(...) const = delete;
};

// Each in place of a type, or of a functor, of the traits.
template <class Base>
struct Traits_without_type : Base
{
  using Base::Base;

private:
  using typename Base::MEMBER;
};

struct No_functor
{
};

template <class Base>
struct Traits_without_functor : Base
{
  using Base::Base;
  No_functor MEMBER() const { return {}; }
};

#if defined(OF_TRAITS)
using Traits = OF_TRAITS<FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
FG::Intrinsic_triangulation<Mesh, Traits> triangulation{Mesh()};
#elif defined(OF_METRIC)
using Metric = Incomplete<FG::Default_metric<Mesh>>;
FG::Intrinsic_triangulation<Mesh, FG::Default_traits<FG::Default_metric<Mesh>>, Metric> triangulation{Mesh()};
#elif defined(OF_NETWORK)
void use(Incomplete<Network>& network) { FG::shorten(network); }
#else
void use(Incomplete<Triangulation>& triangulation)
{
  FG::Edge_path_network<Incomplete<Triangulation>> network(triangulation);
}
#endif
