// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulationTraits` describes the arithmetic of an intrinsic triangulation: the data that are
 * stored for each halfedge, the change of these data by a flip, and the comparison of angles. A triangulation computes
 * its geometry only by the functors of its traits, so the choice of the traits determines the number type.
 *
 * A model must be default constructible and copyable; a triangulation keeps a copy. Functors may refer to the
 * traits object that returned them, but must not rely on a state of their own, since the library requests a new functor
 * for each call.
 *
 * On this page, `h`, `hn` and `hp` are the halfedges of a face in counterclockwise order: a halfedge, the next and the
 * previous one. The geometry of a halfedge is given in a frame of its own face. Each functor receives the geometry of
 * one face, except for `Flip` and `Is_locally_delaunay`, which receive that of both faces of an edge.
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

  /// The number type of squared lengths. Outside the traits, the library does not compute with squared lengths of this
  /// type, but only returns them to the user; lengths are of type `double`.
  typedef unspecified_type FT;

  /// The point type of the mesh, the argument of `Construct_face_3`.
  typedef unspecified_type Point_3;

  /// The geometry that is stored for a halfedge. Default constructible, copyable, and assignable.
  typedef unspecified_type Halfedge_geometry;

  /// The geometry of a face: a range with `operator[]` that contains three objects of type `Halfedge_geometry`, for
  /// `h`, `hn` and `hp`.
  typedef unspecified_type Face_geometry;

  /// A partial sum of the corner angles from one halfedge clockwise to another around a vertex. Copyable; a
  /// default-constructed object is the rotation by zero.
  typedef unspecified_type Turn;

  /// The result of a flip: a class with the members `h`, `t`, `tn`, `tp`, each a `Halfedge_geometry`.
  typedef unspecified_type Flipped_geometry;

  /// `CGAL::Tag_true` if predicates can be wrong because the geometry of halfedges drifts away from that of the input
  /// as the number of flips grows. In this case, `shorten()` rolls back steps that lengthen a curve, measures finished
  /// curves on the input, and continues to shorten those that are bent. `CGAL::Tag_false` if every certain result of
  /// `Compare_turn_with_straight` is correct; `shorten()` then relies on these results.
  typedef unspecified_type Has_drift;

  /// @}
  /// \name Functors that lay out a face
  /// Each of these functors chooses the frame of the face that it constructs.
  /// @{

  /// `Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const`: constructs the face whose
  /// halfedges lead from `p` to `q`, from `q` to `r` and from `r` to `p`. `Embedded_metric` calls the functor for each
  /// input face that is used. \pre the points differ pairwise; they may be collinear
  ///
  /// A further overload, `Face_geometry operator()(const std::array<std::array<double, 3>, 3>& sides) const`, is
  /// optional. It constructs the face whose halfedges have these vectors in space. If this overload exists,
  /// `Embedded_metric` calls it instead of the first one. Each coordinate of a vector is the difference of the
  /// corresponding coordinates of two points, rounded once. Coordinates whose number type is not exact and rational are
  /// rounded to doubles before they are subtracted.
  typedef unspecified_type Construct_face_3;

  /// `Face_geometry operator()(double a, double b, double c) const`: constructs the face whose halfedges have these
  /// lengths, in counterclockwise order. Metrics that are defined by edge lengths, such as `Edge_length_metric`, call
  /// the functor for each input face that is used.
  /// \pre the lengths are positive and satisfy the triangle inequality; equality is allowed
  ///
  /// A further overload, `Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator)
  /// const`, is optional. It constructs the face whose halfedges have exactly the squared lengths
  /// `squares[i] / denominator`. If this overload exists, it is called instead of the first one for metrics with the
  /// member `IntrinsicMetric::squared_length()`. `Integer` is
  /// `boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>`.
  typedef unspecified_type Construct_face_from_lengths;

  /// `Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const`: constructs the
  /// face from the vectors of its halfedges, given as pairs (x, y) in one frame; each vector has an error of at most
  /// `error` times its length. The functor is called when a face is computed from the input, independently of the flips
  /// that created the face, for example after `Is_inaccurate` has returned `true`, around an inserted point, or, if
  /// `Has_drift` is `CGAL::Tag_true`, at a bend of a finished curve.
  typedef unspecified_type Construct_face_2;

  /// @}
  /// \name Functors on angles
  /// @{

  /// `void operator()(Turn& turn, const H& in, const H& out, const H& opposite) const`, with `H = Halfedge_geometry`:
  /// adds to `turn` the corner at the head of `in`, between the consecutive halfedges `in` and `out` of a face;
  /// `opposite` is the third halfedge of the face. All three are given in the frame of this face.
  typedef unspecified_type Extend_turn;

  /// `Uncertain<Comparison_result> operator()(const Turn& turn) const`: compares the angle of `turn` with \f$\pi\f$. If
  /// the result is not `SMALLER`, a joint with this angle is not moved, and an edge is not flipped if its two faces
  /// together have this angle at one of its ends. If the result is uncertain and `Has_drift` is `CGAL::Tag_false`, the
  /// triangulation determines the result by exact arithmetic on the input. If the result is uncertain and `Has_drift`
  /// is `CGAL::Tag_true`, the triangulation throws `CGAL::Uncertain_conversion_exception`. A model may also throw this
  /// exception itself. The functor is called after each corner, and no further corner is added to a turn for which the
  /// result is not `SMALLER`. The functor therefore need not distinguish angles above \f$2\pi\f$ from small angles.
  typedef unspecified_type Compare_turn_with_straight;

  /// `double operator()(const Turn& turn) const`: returns a key that is 0 for the rotation by zero and increases with
  /// the angle of the turn, for angles below \f$\pi\f$. The key determines the order of steps; rounding errors of the
  /// key can change this order, but do not affect the correctness of the result. `Angle_stop_predicate` requires that
  /// the key of an angle \f$\alpha\f$ is \f$1 - \cos\alpha / (|\cos\alpha| + \sin\alpha)\f$.
  typedef unspecified_type Turn_key;

  /// @}
  /// \name Functors on edges
  /// @{

  /// `Flipped_geometry operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: computes the
  /// geometry after the flip of the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`. Afterwards the faces are
  /// `(h, hp, tn)` and `(t, tp, hn)`. The geometry of `hn` and `hp` does not change, so both new faces have the frame
  /// of the old face of `h`. \pre the two old faces together have an angle below \f$\pi\f$ at each end of the old edge
  typedef unspecified_type Flip;

  /// `Uncertain<bool> operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: returns whether
  /// the angles opposite to the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`, at the heads of `hn` and `tn`,
  /// add up to at most \f$\pi\f$. Equality, that is, four points on a circle, counts as Delaunay. A model with rounding
  /// errors must treat an excess below a tolerance as equality; the tolerance must be well above the rounding errors,
  /// so that Lawson's algorithm terminates. If the result is uncertain and `Has_drift` is `CGAL::Tag_false`, the
  /// triangulation determines the result by exact arithmetic on the input. Only
  /// `Intrinsic_triangulation::is_locally_delaunay()` calls this functor.
  typedef unspecified_type Is_locally_delaunay;

  /// `bool operator()(const Halfedge_geometry& h) const`: returns whether the geometry of a halfedge has become so
  /// inaccurate that its face must be recomputed from the input by `Construct_face_2`. The functor is called after each
  /// flip for the four halfedges whose geometry the flip changed; the log keeps the geometry that is replaced. A model
  /// that does not bound its errors returns `false`.
  typedef unspecified_type Is_inaccurate;

  /// `FT operator()(const Halfedge_geometry& h) const`: returns the squared length of a halfedge, which an exact model
  /// computes without a square root. Only `Intrinsic_triangulation::squared_length()` calls this functor.
  typedef unspecified_type Compute_squared_length;

  /// `double operator()(const Halfedge_geometry& h) const`: returns the length of a halfedge, rounded.
  typedef unspecified_type Compute_length;

  /// @}
  /// \name Operations
  /// There is one operation for each functor type.
  /// @{

  /// Returns a functor of type `Construct_face_3`.
  Construct_face_3 construct_face_3_object() const;
  /// Returns a functor of type `Construct_face_from_lengths`.
  Construct_face_from_lengths construct_face_from_lengths_object() const;
  /// Returns a functor of type `Construct_face_2`.
  Construct_face_2 construct_face_2_object() const;
  /// Returns a functor of type `Extend_turn`.
  Extend_turn extend_turn_object() const;
  /// Returns a functor of type `Compare_turn_with_straight`.
  Compare_turn_with_straight compare_turn_with_straight_object() const;
  /// Returns a functor of type `Turn_key`.
  Turn_key turn_key_object() const;
  /// Returns a functor of type `Flip`.
  Flip flip_object() const;
  /// Returns a functor of type `Is_locally_delaunay`.
  Is_locally_delaunay is_locally_delaunay_object() const;
  /// Returns a functor of type `Is_inaccurate`.
  Is_inaccurate is_inaccurate_object() const;
  /// Returns a functor of type `Compute_squared_length`.
  Compute_squared_length compute_squared_length_object() const;
  /// Returns a functor of type `Compute_length`.
  Compute_length compute_length_object() const;

  /// @}
  /// \name Parts of faces
  /// @{

  /// (Optional) `Face_geometry operator()(const Face_geometry& face, const std::array<std::array<double, 3>, 3>& w)
  /// const`: constructs the triangle formed by three points of a face. Each `w[i]` consists of nonnegative weights of
  /// the tails of `h`, `hn` and `hp`; the sum of the weights need not be 1. The functor is called for each part of an
  /// input face that is divided at inserted points. If the type is missing or `void`, the library computes such parts
  /// by `Construct_face_2`, with rounding errors.
  typedef unspecified_type Construct_subface;

  /// (Optional) Returns a functor of type `Construct_subface`; required if that type is present and not `void`.
  Construct_subface construct_subface_object() const;

  /// @}
  /// \name Work limit
  /// @{

  /// Returns the work limit for one sign that the triangulation determines by exact arithmetic because the result of
  /// the traits is uncertain. The unit is that of
  /// `CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits::sign_work_limit()`. This member is required only
  /// if `Has_drift` is `CGAL::Tag_false`.
  std::uint64_t sign_work_limit() const;

  /// @}
};
