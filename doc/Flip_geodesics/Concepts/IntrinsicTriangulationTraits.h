// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The arithmetic of an intrinsic triangulation: what is stored per halfedge, how a flip changes it, and how angles are
 * compared. The rest of the package computes with nothing else, and so a number type is changed by changing this one
 * template argument.
 *
 * A model is default constructible and copyable; a triangulation keeps a copy. Functors may refer to the object that
 * they come from, and have no state of their own that matters: the library asks for one, calls it and throws it away.
 *
 * Throughout, the halfedges of a face are named `h`, `hn`, `hp`: a halfedge, the next and the previous one around the
 * face, counterclockwise. The geometry of a halfedge is given in a frame of its own face. Only quantities of one face
 * are ever combined, except in `Flip`, which has both faces of an edge.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Intrinsic_triangulation_traits<K>}
 * \cgalHasModels{CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits<K>}
 * \cgalHasModels{CGAL::Flip_geodesics::Exact_intrinsic_triangulation_traits<NT\,K>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::Intrinsic_triangulation`
 */
class IntrinsicTriangulationTraits
{
public:
  /// \name Types
  /// @{

  /// The number type of squared lengths. The library computes with none of it: it hands squared lengths out, and takes
  /// lengths as `double`.
  typedef unspecified_type FT;

  /// The point type of the mesh, the argument of `Construct_face_3`.
  typedef unspecified_type Point_3;

  /// What a halfedge stores. Default constructible, copyable, assignable. If it is trivially copyable, then a
  /// triangulation costs nothing where it is not touched; if not, its records are all made at construction.
  typedef unspecified_type Halfedge_geometry;

  /// The geometry of a face: a range of three `Halfedge_geometry`, of `h`, `hn`, `hp`, with `operator[]`.
  typedef unspecified_type Face_geometry;

  /// A rotation about a vertex, from one halfedge clockwise to another, as far as it has been accumulated. Copyable;
  /// default constructed it is the rotation by zero.
  typedef unspecified_type Turn;

  /// What a flip changes: a class with the members `h`, `t`, `tn`, `tp`, each a `Halfedge_geometry`.
  typedef unspecified_type Flipped_geometry;

  /// `CGAL::Tag_true` if decisions can be wrong, because the geometry of halfedges drifts away from the input's with
  /// flips. Then `shorten()` takes back steps that lengthen a curve, measures finished curves afresh, and goes on
  /// where they are bent. `CGAL::Tag_false` if what `Compare_turn_with_straight` calls certain is true; `shorten()`
  /// relies on it then.
  typedef unspecified_type Has_drift;

  /// @}
  /// \name Functors that lay out a face
  /// The frame is the functor's choice.
  /// @{

  /// `Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const`: the face whose halfedges
  /// lead from `p` to `q`, from `q` to `r` and from `r` to `p`. Called once per input face that is touched, by
  /// `Embedded_metric`. \pre the points differ pairwise; they may be collinear
  typedef unspecified_type Construct_face_3;

  /// `Face_geometry operator()(double a, double b, double c) const`: the face whose halfedges have these lengths, in
  /// the order of the face. Called once per input face that is touched, by `Edge_length_metric`. \pre the lengths are
  /// positive and satisfy the triangle inequality; equality is allowed. The functors of the models
  /// of this package are also called with exact squared lengths, and `Construct_face_3` with rounded sides, in types of
  /// the package; these overloads are not part of the concept, and other models get doubles and points
  typedef unspecified_type Construct_face_from_lengths;

  /// `Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const`: the face whose
  /// halfedges have these vectors, pairs x, y in one frame of the face, each with an error of at most `error` times its
  /// length. Called where a face is laid out afresh from the input, whatever flips led to it: after `Is_inaccurate` has
  /// asked for it, and if `Has_drift` is `CGAL::Tag_true` where a finished curve is measured to be bent.
  typedef unspecified_type Construct_face_2;

  /// @}
  /// \name Functors on angles
  /// @{

  /// `void operator()(Turn& turn, const H& in, const H& out, const H& opposite) const`, with `H = Halfedge_geometry`:
  /// adds to `turn` the corner between two consecutive halfedges of a face, at the head of `in`; `opposite` is the
  /// third one. All three are in the frame of that face.
  typedef unspecified_type Extend_turn;

  /// `Uncertain<Comparison_result> operator()(const Turn& turn) const`: the angle of `turn` compared with \f$\pi\f$.
  /// What is not `SMALLER` counts as straight: it is neither shortened nor flipped. If the answer is uncertain and
  /// `Has_drift` is `CGAL::Tag_false`, then the triangulation decides by exact arithmetic on the input. Otherwise
  /// `CGAL::Uncertain_conversion_exception` is thrown; a model may also throw it itself. A turn is asked after each
  /// corner and never extended once it is not smaller. So angles above \f$2\pi\f$ need not be told apart from small
  /// ones.
  typedef unspecified_type Compare_turn_with_straight;

  /// `double operator()(const Turn& turn) const`: a key that grows with the angle of a turn below \f$\pi\f$, 0 for the
  /// rotation by zero. It orders the queue, so its rounding has an influence on the order of steps and on nothing
  /// else. Where `Angle_stop_predicate` is to be used, the key of an angle \f$\alpha\f$ is
  /// \f$1 - \cos\alpha / (|\cos\alpha| + \sin\alpha)\f$.
  typedef unspecified_type Turn_key;

  /// @}
  /// \name Functors on edges
  /// @{

  /// `Flipped_geometry operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: the geometry
  /// after the flip of the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`. Afterwards the faces are
  /// `(h, hp, tn)` and `(t, tp, hn)`; the geometry of `hn` and `hp` stays what it is. So the new faces have the frame
  /// of the old face of `h`. \pre the quad is convex, its angles at both ends of the old edge below \f$\pi\f$
  typedef unspecified_type Flip;

  /// `Uncertain<bool> operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: are the angles
  /// opposite to the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`, at the heads of `hn` and `tn`, together at
  /// most \f$\pi\f$? Equality, four points on a circle, counts as Delaunay. A model that rounds counts an excess below
  /// a tolerance as equality, the tolerance well above its errors, so that Lawson's algorithm ends. If the answer is
  /// uncertain and `Has_drift` is `CGAL::Tag_false`, then the triangulation decides by exact arithmetic on the input.
  /// Called by `Intrinsic_triangulation::is_locally_delaunay()` and by nothing else.
  typedef unspecified_type Is_locally_delaunay;

  /// `bool operator()(const Halfedge_geometry& h) const`: has the geometry of a halfedge become so inaccurate that its
  /// face is to be laid out afresh from the input, by `Construct_face_2`? Asked after a flip for the four halfedges
  /// that it changed; the log keeps what is replaced. A model without a bound of its error answers `false`.
  typedef unspecified_type Is_inaccurate;

  /// `FT operator()(const Halfedge_geometry& h) const`: the squared length of a halfedge, which an exact model can give
  /// without a root. Called by `Intrinsic_triangulation::squared_length()` and by nothing else.
  typedef unspecified_type Compute_squared_length;

  /// `double operator()(const Halfedge_geometry& h) const`: the length of a halfedge, rounded.
  typedef unspecified_type Compute_length;

  /// @}
  /// \name Operations
  /// One for each functor type.
  /// @{

  /// A functor of type `Construct_face_3`.
  Construct_face_3 construct_face_3_object() const;
  /// A functor of type `Construct_face_from_lengths`.
  Construct_face_from_lengths construct_face_from_lengths_object() const;
  /// A functor of type `Construct_face_2`.
  Construct_face_2 construct_face_2_object() const;
  /// A functor of type `Extend_turn`.
  Extend_turn extend_turn_object() const;
  /// A functor of type `Compare_turn_with_straight`.
  Compare_turn_with_straight compare_turn_with_straight_object() const;
  /// A functor of type `Turn_key`.
  Turn_key turn_key_object() const;
  /// A functor of type `Flip`.
  Flip flip_object() const;
  /// A functor of type `Is_locally_delaunay`.
  Is_locally_delaunay is_locally_delaunay_object() const;
  /// A functor of type `Is_inaccurate`.
  Is_inaccurate is_inaccurate_object() const;
  /// A functor of type `Compute_squared_length`.
  Compute_squared_length compute_squared_length_object() const;
  /// A functor of type `Compute_length`.
  Compute_length compute_length_object() const;

  /// @}
  /// \name Parts of faces
  /// @{

  /// Optional. `Face_geometry operator()(const Face_geometry& face, const std::array<std::array<double, 3>, 3>& w)
  /// const`: the triangle of three points in a face. Each `w[i]` consists of nonnegative weights of the tails of `h`,
  /// `hn` and `hp`, whose sum need not be 1. Called for the parts of an input face that is divided at points. If the
  /// type is missing or `void`, such parts are made by `Construct_face_2`, with rounding errors.
  typedef unspecified_type Construct_subface;

  /// Optional, required with `Construct_subface`. A functor of this type.
  Construct_subface construct_subface_object() const;

  /// @}
  /// \name Limit of work
  /// @{

  /// The limit of work for one sign that the traits leave open and the triangulation decides by exact arithmetic, in the
  /// unit of `CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits::sign_work_limit()`. Needed only if
  /// `Has_drift` is `CGAL::Tag_false`.
  std::uint64_t sign_work_limit() const;

  /// @}
};
