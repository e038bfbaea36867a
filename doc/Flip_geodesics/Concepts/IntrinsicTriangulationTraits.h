// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulationTraits` describes the arithmetic of an intrinsic triangulation: the data that are
 * stored for each halfedge, the change of these data by a flip, and the comparison of angles. A triangulation computes
 * its geometry only with the functors of its traits, so the choice of the traits determines the number type.
 *
 * A model must be default constructible and copyable; a triangulation keeps a copy. A functor may refer to the traits
 * object that returned it, but must not rely on a state of its own, since the library requests a new functor for each
 * call.
 *
 * On this page, `h`, `hn` and `hp` are the three halfedges of a face: `hn` is the next halfedge after `h` in
 * counterclockwise order, and `hp` is the previous halfedge. The halfedges `t`, `tn` and `tp` of a second face are
 * named in the same way.
 *
 * The geometry of a halfedge is given in a coordinate frame of the face on its left. Different faces can have different
 * frames.
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

  /// The point type of the mesh. `Construct_face_3` takes points of this type.
  typedef unspecified_type Point_3;

  /// The geometry that is stored for a halfedge. The type must be default constructible, copyable, and assignable.
  typedef unspecified_type Halfedge_geometry;

  /// The geometry of a face: a range with `operator[]` that contains three objects of type `Halfedge_geometry`, for
  /// `h`, `hn` and `hp`.
  typedef unspecified_type Face_geometry;

  /// A sum of consecutive corner angles, clockwise around a vertex. The type must be copyable. A default-constructed
  /// object has the angle zero.
  typedef unspecified_type Turn;

  /// The result of a flip: a class with the members `h`, `t`, `tn` and `tp` of type `Halfedge_geometry`.
  typedef unspecified_type Flipped_geometry;

  /// This type is `CGAL::Tag_true` if predicates can be wrong because the errors in the geometry of halfedges grow with
  /// the number of flips. `shorten()` then rolls back steps that lengthen a curve, measures finished curves on the
  /// input, and continues to shorten bent curves.
  ///
  /// This type is `CGAL::Tag_false` if every certain result of `Compare_turn_with_straight` is correct. `shorten()`
  /// then relies on these results.
  typedef unspecified_type Has_drift;

  /// @}
  /// \name Functors that lay out a face
  /// Each of these functors chooses the frame of the face that it constructs.
  /// @{

  /// `Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const`: constructs the face whose
  /// halfedges lead from `p` to `q`, from `q` to `r` and from `r` to `p`. `Embedded_metric` calls the functor for each
  /// input face that is used. \pre no two of the points are equal; the points may be collinear
  ///
  /// A further overload, `Face_geometry operator()(const std::array<std::array<double, 3>, 3>& sides) const`, is
  /// optional. It constructs the face whose halfedges have the vectors `sides` in space. If this overload exists,
  /// `Embedded_metric` calls it instead of the first one. Each coordinate of a vector is the difference of the
  /// corresponding coordinates of two points, rounded once. Coordinates whose number type is not exact and rational are
  /// rounded to doubles before they are subtracted.
  typedef unspecified_type Construct_face_3;

  /// `Face_geometry operator()(double a, double b, double c) const`: constructs the face whose halfedges have the
  /// lengths `a`, `b` and `c`, in counterclockwise order. Metrics that are defined by edge lengths, such as
  /// `Edge_length_metric`, call the functor for each input face that is used.
  /// \pre the lengths are positive and satisfy the triangle inequality; equality is allowed
  ///
  /// A further overload, `Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator)
  /// const`, is optional. It constructs the face whose halfedges have exactly the squared lengths
  /// `squares[i] / denominator`. If this overload exists, the library calls it instead of the first one for metrics
  /// with the member `IntrinsicMetric::squared_length()`. `Integer` is
  /// `boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>`.
  typedef unspecified_type Construct_face_from_lengths;

  /// `Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const`: constructs the face
  /// whose halfedges have the vectors `v`, given as pairs (x, y) in one frame. The error of each vector is at most
  /// `error` times the length of the vector.
  ///
  /// The library calls this functor when it computes a face from the input, independently of the flips that created the
  /// face. Examples are a face for which `Is_inaccurate` has returned `true`, the faces around an inserted point, and,
  /// if `Has_drift` is `CGAL::Tag_true`, the faces at a bend of a finished curve.
  typedef unspecified_type Construct_face_2;

  /// @}
  /// \name Functors on angles
  /// @{

  /// `void operator()(Turn& turn, const H& in, const H& out, const H& opposite) const`, where `H` is
  /// `Halfedge_geometry`: adds to `turn` the corner between the consecutive halfedges `in` and `out` of a face, at the
  /// head of `in`. The argument `opposite` is the third halfedge of the face. The geometry of all three halfedges is
  /// given in the frame of this face.
  typedef unspecified_type Extend_turn;

  /// `Uncertain<Comparison_result> operator()(const Turn& turn) const`: compares the angle of `turn` with \f$\pi\f$. If
  /// the result is not `SMALLER`, a joint with this angle is not moved. Likewise, an edge is not flipped if its two
  /// faces together have such an angle at one of its ends.
  ///
  /// If the result is uncertain and `Has_drift` is `CGAL::Tag_false`, the triangulation determines the result by exact
  /// arithmetic on the input. If the result is uncertain and `Has_drift` is `CGAL::Tag_true`, the triangulation throws
  /// `CGAL::Uncertain_conversion_exception`. A model may also throw this exception itself.
  ///
  /// The turn consists of the two corners that the faces of an edge have at one end of the edge, or its angle was at
  /// most \f$\pi\f$ before the last corner was added. Since each corner is at most \f$\pi\f$, the angle never exceeds
  /// \f$2\pi\f$.
  typedef unspecified_type Compare_turn_with_straight;

  /// `double operator()(const Turn& turn) const`: returns a key by which turns with angles below \f$\pi\f$ are ordered.
  /// The key must be 0 for the angle zero, and must increase with the angle. The keys determine the order of steps.
  /// Rounding errors of the keys can change this order, but do not affect the correctness of the result.
  /// `Angle_stop_predicate` requires that the key of an angle \f$\alpha\f$ is
  /// \f$1 - \cos\alpha / (|\cos\alpha| + \sin\alpha)\f$.
  typedef unspecified_type Turn_key;

  /// @}
  /// \name Functors on edges
  /// @{

  /// `Flipped_geometry operator()(h, hn, hp, t, tn, tp) const`, where all arguments are of type
  /// `const Halfedge_geometry&`: computes the geometry after the flip of the edge between the faces `(h, hn, hp)` and
  /// `(t, tn, tp)`. After the flip, the faces are `(h, hp, tn)` and `(t, tp, hn)`. The geometry of `hn` and `hp` does
  /// not change, so both new faces have the frame of the old face of `h`. \pre the two old faces together have an angle
  /// below \f$\pi\f$ at each end of the old edge
  typedef unspecified_type Flip;

  /// `Uncertain<bool> operator()(h, hn, hp, t, tn, tp) const`, where all arguments are of type
  /// `const Halfedge_geometry&`: returns whether the edge between the faces `(h, hn, hp)` and `(t, tn, tp)` is locally
  /// Delaunay. This is the case if the angles at the heads of `hn` and `tn`, which are opposite to the edge, add up to
  /// at most \f$\pi\f$. If the sum is equal to \f$\pi\f$, the four vertices lie on a circle, and the edge is locally
  /// Delaunay.
  ///
  /// A model with rounding errors must treat a sum that exceeds \f$\pi\f$ by less than a tolerance as equal to
  /// \f$\pi\f$. The tolerance must be well above the rounding errors, so that Lawson's algorithm terminates.
  ///
  /// Only `Intrinsic_triangulation::is_locally_delaunay()` calls this functor. If the result is uncertain and
  /// `Has_drift` is `CGAL::Tag_false`, the triangulation determines the result by exact arithmetic on the input.
  typedef unspecified_type Is_locally_delaunay;

  /// `bool operator()(const Halfedge_geometry& h) const`: returns whether the geometry of a halfedge has become so
  /// inaccurate that its face must be recomputed from the input by `Construct_face_2`. After each flip, the library
  /// calls the functor for the four halfedges whose geometry the flip changed. When a face is recomputed, the log keeps
  /// the old geometry of the face. A model that does not bound its errors returns `false`.
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
  /// const`: constructs the triangle formed by three points of a face. `w[i]` contains the weights of the tails of `h`,
  /// `hn` and `hp` for point `i`. The weights are nonnegative, and their sum need not be 1.
  ///
  /// If an input face is divided at inserted points, the library calls the functor for each part of the face. If the
  /// type is missing or `void`, the library computes the parts by `Construct_face_2`, with rounding errors.
  typedef unspecified_type Construct_subface;

  /// (Optional) Returns a functor of type `Construct_subface`; required if that type is present and not `void`.
  Construct_subface construct_subface_object() const;

  /// @}
  /// \name Work limit
  /// @{

  /// Returns the work limit for one sign. The triangulation determines a sign by exact arithmetic if the result of a
  /// functor is uncertain. The unit of the limit is that of
  /// `CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits::sign_work_limit()`. This member is required only
  /// if `Has_drift` is `CGAL::Tag_false`.
  std::uint64_t sign_work_limit() const;

  /// @}
};
