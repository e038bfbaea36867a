// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * An observer of a refinement, for progress and interruption.
 *
 * \cgalRefines{FlipOutVisitor}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Default_shortening_visitor}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::refine()`
 */
class RefinementVisitor
{
public:
  /// Called after vertex `v` was inserted into a face or on an edge, and the edges around it were flipped. There is no
  /// call for a vertex that is taken back.
  template <class Triangulation>
  void on_insertion(const Triangulation& triangulation, Vertex_index v);
};
