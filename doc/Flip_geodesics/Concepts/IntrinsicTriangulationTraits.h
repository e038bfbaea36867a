// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulationTraits` describes the arithmetic of an intrinsic triangulation: the data that are
 * stored for each halfedge, the change of these data by a flip, and the comparison of angles. A triangulation computes
 * its geometry only by means of a model, so this template argument selects the number type.
 *
 * A model must be default constructible and copyable; a triangulation keeps a copy. Functors may refer to the traits
 * object that returned them, but must not rely on a state of their own, since a functor is requested for each call.
 *
 * On this page, `h`, `hn` and `hp` are the halfedges of a face in counterclockwise order: a halfedge, the next and the
 * previous one. The geometry of a halfedge is given in a frame of its own face. Functors combine only quantities of one
 * face, except for `Flip`, which receives both faces of an edge.
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

  /// The number type of squared lengths. The library returns squared lengths of this type and does not compute with
  /// them; lengths are of type `double`.
  typedef unspecified_type FT;

  /// The point type of the mesh, the argument of `Construct_face_3`.
  typedef unspecified_type Point_3;

  /// The geometry that is stored for a halfedge. Default constructible, copyable, and assignable. If the type is
  /// trivially copyable, the triangulation allocates records only for the part of the mesh that is used; otherwise it
  /// constructs all records at once.
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
  /// as the number of flips grows. In this case `shorten()` rolls back steps that lengthen a curve, measures finished
  /// curves on the input, and continues if they are bent. `CGAL::Tag_false` if every certain result of
  /// `Compare_turn_with_straight` is correct; `shorten()` then relies on these results.
  typedef unspecified_type Has_drift;

  /// @}
  /// \name Functors that lay out a face
  /// The functor chooses the frame of the face.
  /// @{

  /// `Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const`: constructs the face whose
  /// halfedges lead from `p` to `q`, from `q` to `r` and from `r` to `p`. `Embedded_metric` calls it once for each
  /// input face that is used. \pre the points differ pairwise; they may be collinear
  ///
  /// A further overload, `Face_geometry operator()(const std::array<std::array<double, 3>, 3>& sides) const`, is
  /// optional. It constructs the face whose halfedges have these vectors in space. If it exists, `Embedded_metric`
  /// calls it instead. Each coordinate of a vector is the difference of the corresponding coordinates of two points,
  /// rounded once. Coordinates that are not exact rational numbers are rounded to doubles before they are subtracted.
  typedef unspecified_type Construct_face_3;

  /// `Face_geometry operator()(double a, double b, double c) const`: constructs the face whose halfedges have these
  /// lengths, in counterclockwise order. `Edge_length_metric` calls it once for each input face that is used.
  /// \pre the lengths are positive and satisfy the triangle inequality; equality is allowed
  ///
  /// A further overload, `Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator)
  /// const`, is optional. It constructs the face whose halfedges have exactly the squared lengths
  /// `squares[i] / denominator`. If it exists, it is called instead for metrics with the member
  /// `IntrinsicMetric::squared_length()`. `Integer` is
  /// `boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>`.
  typedef unspecified_type Construct_face_from_lengths;

  /// `Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const`: constructs the
  /// face from the vectors of its halfedges, given as pairs (x, y) in one frame; each vector has an error of at most
  /// `error` times its length. It is called when a face is recomputed from the input, independently of the flips that
  /// created the face: after `Is_inaccurate` has returned `true`, and, if `Has_drift` is `CGAL::Tag_true`, when a
  /// finished curve is found to be bent.
  typedef unspecified_type Construct_face_2;

  /// @}
  /// \name Functors on angles
  /// @{

  /// `void operator()(Turn& turn, const H& in, const H& out, const H& opposite) const`, with `H = Halfedge_geometry`:
  /// adds to `turn` the corner at the head of `in`, between the consecutive halfedges `in` and `out` of a face;
  /// `opposite` is the third halfedge. All three are given in the frame of that face.
  typedef unspecified_type Extend_turn;

  /// `Uncertain<Comparison_result> operator()(const Turn& turn) const`: compares the angle of `turn` with \f$\pi\f$. If
  /// the result is not `SMALLER`, a joint with this angle is not shortened, and an edge at whose end its two faces have
  /// this angle is not flipped. If the result is uncertain, the triangulation determines it by exact arithmetic on the
  /// input, provided that `Has_drift` is `CGAL::Tag_false`, and otherwise throws
  /// `CGAL::Uncertain_conversion_exception`. A model may also throw this exception itself. The functor is called after
  /// each corner, and a turn that is not `SMALLER` is not extended further. The functor therefore need not distinguish
  /// angles above \f$2\pi\f$ from small angles.
  typedef unspecified_type Compare_turn_with_straight;

  /// `double operator()(const Turn& turn) const`: returns a key that is 0 for the rotation by zero and increases with
  /// the angle of the turn, for angles below \f$\pi\f$. Since the key determines only the order in the queue, its
  /// rounding error affects only the order of steps. `Angle_stop_predicate` requires that the key of an angle
  /// \f$\alpha\f$ is \f$1 - \cos\alpha / (|\cos\alpha| + \sin\alpha)\f$.
  typedef unspecified_type Turn_key;

  /// @}
  /// \name Functors on edges
  /// @{

  /// `Flipped_geometry operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: computes the
  /// geometry after the flip of the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`. Afterwards the faces are
  /// `(h, hp, tn)` and `(t, tp, hn)`. The geometry of `hn` and `hp` does not change, so both new faces have the frame
  /// of the old face of `h`. \pre the quadrilateral is convex, with angles below \f$\pi\f$ at both ends of the old edge
  typedef unspecified_type Flip;

  /// `Uncertain<bool> operator()(h, hn, hp, t, tn, tp) const`, all of type `const Halfedge_geometry&`: returns whether
  /// the angles opposite to the edge between the faces `(h, hn, hp)` and `(t, tn, tp)`, at the heads of `hn` and `tn`,
  /// add up to at most \f$\pi\f$. Equality, that is, four points on a circle, counts as Delaunay. A model with rounding
  /// errors treats an excess below a tolerance as equality; the tolerance must be well above these errors, so that
  /// Lawson's algorithm terminates. If the result is uncertain and `Has_drift` is `CGAL::Tag_false`, the triangulation
  /// determines the result by exact arithmetic on the input. Only `Intrinsic_triangulation::is_locally_delaunay()`
  /// calls it.
  typedef unspecified_type Is_locally_delaunay;

  /// `bool operator()(const Halfedge_geometry& h) const`: returns whether the geometry of a halfedge has become so
  /// inaccurate that its face must be recomputed from the input by `Construct_face_2`. It is called after a flip for
  /// the four halfedges that the flip changed; the log keeps the replaced geometry. A model that does not bound its
  /// errors returns `false`.
  typedef unspecified_type Is_inaccurate;

  /// `FT operator()(const Halfedge_geometry& h) const`: returns the squared length of a halfedge, which an exact model
  /// computes without a square root. Only `Intrinsic_triangulation::squared_length()` calls it.
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
  /// input face that is divided at points. If the type is missing or `void`, such parts are computed by
  /// `Construct_face_2`, with rounding errors.
  typedef unspecified_type Construct_subface;

  /// (Optional) Returns a functor of type `Construct_subface`; required if that type is present and not `void`.
  Construct_subface construct_subface_object() const;

  /// @}
  /// \name Work limit
  /// @{

  /// Returns the work limit for the computation of one sign that the traits leave uncertain and the triangulation
  /// determines by exact arithmetic, in the unit of
  /// `CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits::sign_work_limit()`. Required only if `Has_drift`
  /// is `CGAL::Tag_false`.
  std::uint64_t sign_work_limit() const;

  /// @}
};
