// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `RefinementVisitor` describes an observer of a refinement. A visitor can report progress or stop the
 * refinement.
 *
 * \cgalRefines{FlipOutVisitor}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Default_shortening_visitor}
 * \cgalHasModels{CGAL::Flip_geodesics::Time_stop_predicate}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::refine()`
 */
class RefinementVisitor
{
public:
  /// Is called after vertex `v` has been inserted into a face or on an edge and the edges around it have been flipped.
  /// This member is not called for an insertion that is rolled back.
  template <class Triangulation>
  void on_insertion(const Triangulation& triangulation, Vertex_index v);
};
