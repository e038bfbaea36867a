// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TOLERANCES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TOLERANCES_H

/*
 * All numbers of the package that bound an error, decide whether two values count as equal, or limit a range. They are
 * dimensionless unless stated otherwise; angles are in radians. A tolerance is relative to the quantity that its
 * comment names. test/Flip_geodesics/check_tolerances.py refuses such literals in other headers.
 */

#include <cstdint>

namespace CGAL::Flip_geodesics::internal {

// ---- Rounding errors

/* The relative error of one operation on doubles, rounded to nearest; u below. */
inline constexpr double unit_roundoff = 0x1p-53;

/* The relative error of n operations in a row, to first order. */
constexpr double rounding_errors(double n) { return n * unit_roundoff; }

/* A relative error that is negligible beside one rounding error: with it, a rounded number errs by a millionth more. */
inline constexpr double negligible_rounding = 0x1p-20 * unit_roundoff;

/* The relative error of a length in a search, up to which coordinates with a bound on their error need not be refined:
 * that of 2^-40 of a path's length that no more than decides where curves start. */
inline constexpr double search_length_error = 0x1p-40;

/* The largest double below 1. */
inline constexpr double largest_below_one = 1 - unit_roundoff;

/* The relative error of an operation on double-double numbers: at most 13 u^2, by the derivation at `Double_double`. */
inline constexpr double double_double_error = 16 * unit_roundoff * unit_roundoff;

/* The relative error of an operation on vectors of double-double numbers: at most 33 u^2, derived there as well. */
inline constexpr double double_double_vector_error = 64 * unit_roundoff * unit_roundoff;

/* The error of a direction in a face laid out in double-double numbers: twice the bound of 2^8 u^2 that is derived at
 * `Precise_face_traits`. */
inline constexpr double precise_direction_error = 512 * unit_roundoff * unit_roundoff;

/* By what part a bound that was computed by up to some thousand operations on nonnegative doubles may come out too
 * small. */
inline constexpr double bound_rounding = rounding_errors(1 << 13);

/* Error bounds of first order hold where each error is below `largest_first_order_error`, relative to its quantity.
 * The products of errors that they leave out are less than `second_order_errors` of the bound: four such products. */
inline constexpr double largest_first_order_error = 0x1p-20;
inline constexpr double second_order_errors = 4 * largest_first_order_error;

/* The error of an edge derived from other edges in double-double numbers, above which the edge is laid out along its
 * own sequence of crossed edges instead. Such numbers have 2^-106; 42 bits are left for the number of derivations and
 * for the shapes of faces. */
inline constexpr double largest_derived_error = 0x1p-64;

/* The enlargement of a radius of a ball, itself computed in few operations: about 90 u, and 9000 u where it has been
 * multiplied repeatedly. A larger one costs nothing but a repetition with more digits. */
inline constexpr double radius_rounding = 1e-14, product_radius_rounding = 1e-12;

/* The default work limit for one sign by exact arithmetic, in products of two 64-bit words, each of which takes
 * about a nanosecond: a tenth of a second. */
inline constexpr std::uint64_t default_sign_work = std::uint64_t(1) << 27;

/* The error of a distance in the plane or in space as a lower bound: the difference, the sum of squares, its root and
 * the factor take fewer than 8 rounded operations. */
inline constexpr double distance_bound_rounding = rounding_errors(8);

/* The error of squared areas, and of sums of squares times areas, of triangles whose longest side is between 1 and 2:
 * some 20 rounded operations on numbers of up to 16, and sides that are off by some units in the last place, make less
 * than 512 u. `stretch_rounding` is for the quotients and roots that follow. */
inline constexpr double area_product_error = rounding_errors(512), stretch_rounding = bound_rounding;

/* The error of determinants of places: eight rounded operations, three differences, two products and three sums. A
 * thousandth more is for the bound itself. */
inline constexpr double determinant_error = 8.001 * unit_roundoff;

/* Coordinates of a point by weights in a triangle: three products, two sums and a quotient, of rounded coordinates. */
inline constexpr double weighted_place_error = rounding_errors(8);

/* A vector of a face that is laid out in double: differences (2), dot or cross products (8), roots and quotients (3)
 * make 13 u in each coordinate. */
inline constexpr double face_layout_error = rounding_errors(32);

/* The product of two vectors as complex numbers: two products and a sum, less than 4 u in each coordinate. */
inline constexpr double vector_product_error = rounding_errors(16);

/* The rotation by the quotient of two vectors: a product, a squared length, a quotient and another product. */
inline constexpr double rotation_error = rounding_errors(32);

/* The quotient of two vectors of a face, and its product with another one: three errors of a layout. */
inline constexpr double face_ratio_error = 3 * face_layout_error;

/* An angle of an input face, from its layout by an arc tangent, and in a sum of a few such angles. */
inline constexpr double input_corner_error = rounding_errors(200);

/* An angle between two directions measured by arc tangents, a difference and a sum, of numbers of up to 2 pi. */
inline constexpr double measured_angle_error = rounding_errors(32);

/* Sums of up to six products of two or three numbers, relative to the sum of the absolute values, and coordinates of a
 * vector that is rotated by a rounded unit vector: less than 8 u, twice that with the rounding of the bound. */
inline constexpr double product_sum_error = rounding_errors(16);

/* The height of a degenerate face in a rounded layout, relative to its base: four errors of a layout. Faces below it
 * are examined exactly. */
inline constexpr double flat_layout_error = 4 * face_layout_error;

/* The relative error of the root of an integer that was rounded to double. */
inline constexpr double root_rounding = rounding_errors(8);

/* The size of a cell relative to the largest coordinate, from which on numbers of cells are exact in double. */
inline constexpr double least_cell_size = rounding_errors(8);

/* The relative error of a sum of lengths, of up to 9000 terms: that many u. Lengths that differ by less count as
 * equal. On longer paths rounding errors can exceed it, but only if they all have the same sign. */
inline constexpr double length_sum_rounding = 1e-12;

/* The relative change of a curve's length from which on it is more than rounding errors of the length: 90 u. A step
 * that lengthens the curve by more was decided wrongly and is rolled back. Steps that shorten it by less are limited
 * in number. */
inline constexpr double visible_length_change = 1e-14;

/* The rounding errors of a mean of squared distances, relative to it: 90 u. */
inline constexpr double variance_rounding = 1e-14;

/* The relative error of lower bounds for classes of paths, sums of at most 2^13 lengths. */
inline constexpr double class_bound_rounding = bound_rounding;

// ---- Ranges

/* Edge lengths. The fourth powers of all of them are normal doubles, so products of squares neither overflow nor
 * lose digits. The same bound holds for coordinates. */
inline constexpr double least_length = 1e-70, greatest_length = 1e70;

/* Squared distances of which the length is certainly in that range, so no root needs to be taken: an order of
 * magnitude inside. */
inline constexpr double least_safe_square = 10 * least_length * least_length,
                        greatest_safe_square = greatest_length * greatest_length / 10;

/* Barycentric weights inside an edge or a face. Sums and products of three of them, and of two with a length, are
 * normal doubles. */
inline constexpr double least_weight = 1e-100, greatest_weight = 1e100;

/* Numbers between these have products of five factors that neither overflow nor underflow. Vectors are scaled as soon
 * as they leave the range. */
inline constexpr double greatest_unscaled = 0x1p200, least_unscaled = 0x1p-200;

/* Keys of angles are quotients of a vector's coordinates and its size. For exact numbers they are computed in double
 * only between these sizes, far enough from where coordinates lose digits or overflow. */
inline constexpr double greatest_quotient_size = 0x1p900, least_quotient_size = 0x1p-900;

/* Factors of which the product of three, and of two, is exact as an expansion: neither overflows, nor is the last bit
 * of the product lost, which is 2^-53 of each factor below the first one. */
inline constexpr double greatest_of_three_factors = 0x1p250, least_of_three_factors = 0x1p-250;
inline constexpr double greatest_of_two_factors = 0x1p450, least_of_two_factors = 0x1p-450;

/* The absolute error of a determinant through underflow, if no entry is above `greatest_of_three_factors`: each of its
 * six products of two loses at most 2^-1075, which the third factor multiplies. */
inline constexpr double underflow_of_products = 0x1p-800;

/* The absolute error through underflow of determinants whose error bound contains the cube of the rounding errors of
 * the coordinates, which exceeds the loss where these are above 2^-464. */
inline constexpr double underflow_of_small_products = 0x1p-900;

/* The sum of a coordinate and the largest one times this number is exact only if the coordinate is a multiple of about
 * 2^-13 of the largest one: then both are short integers in some unit. */
inline constexpr double short_coordinate_shift = 0x1p39;

/* The smallest power of two that is a sign tolerance of a number type with many digits. */
inline constexpr int least_tolerance_exponent = -1000;

// ---- Predicates

/* Radians by which a straight angle may be missed by the traits of double arithmetic: far more than the rounding
 * errors of one flip, which are some u. A curve that bends by less is not shortened. Curves are measured from the
 * input alone in the end (`certify()`), which does not depend on this number. */
inline constexpr double straight_angle_tolerance = 1e-9;

/* Radians by which flips decided in double may have been wrong in all, before a point is inserted. Faces that fit
 * their input worse than this make the insertion fail with an exception; nothing wrong is returned. */
inline constexpr double largest_angle_drift = 1e-5;

/* How far beside the nearest face of the triangulation a point may lie, relative to the edge. An insertion that misses
 * by more fails with an exception. */
inline constexpr double largest_point_miss = 1e-6;

/* Barycentric weights below this count as zero, that is, the point lies on the edge: 9 u, what a weight computed from
 * two others errs by. A larger weight that stems from rounding leaves a point an unnoticeable distance off its edge. */
inline constexpr double zero_weight = 1e-15;

/* Barycentric weights from cross products of a layout that are below this count as zero; their errors are ten times as
 * large. */
inline constexpr double zero_layout_weight = 1e-14;

/* How far apart points of the triangulation have to be, relative to the edge or the face they lie in. Weights are off
 * by `zero_weight`, so angles at points so close are off by 1e-6, a tenth of `largest_angle_drift`. */
inline constexpr double least_point_spacing = 1e-9;

/* Lengths of the sides of a face that differ by at most this, relatively, are of one and the same face, which has been
 * recomputed in between. Another face of the same shape does just as well. */
inline constexpr double same_shape = 1e-9;

/* Curves of a family begin at one point if its weights differ by at most this: points are rounded when they are
 * computed or written with ten digits. Curves that begin farther apart are refused with an exception. */
inline constexpr double same_start = 1e-9;

/* Barycentric coordinates that a program passes have to sum to one up to this, and to be at most 1 up to this: six
 * digits are what streams print by default. Other points are refused with an exception. */
inline constexpr double weight_sum_tolerance = 1e-6;

/* Radians by which the corner of a region of a subdivision may exceed pi without counting as reflex: curves have been
 * straightened up to `straight_angle_tolerance`, and were laid out from rounded angles. Regions with reflex corners
 * keep the lines that divide them. */
inline constexpr double straight_division = 1e-7;

/* Radians, and parts of the length of a segment, by which a path in a sleeve may pass a corner on the wrong side
 * before it is corrected: 9000 u, for strips of about a thousand faces. A correction that rounding errors make in vain
 * is bounded by the number of rounds. */
inline constexpr double straight_in_sleeve = 1e-12;

/* The value of `straight_in_sleeve` for a path that the last round of correction has still changed. Beyond this an
 * exception is thrown. */
inline constexpr double straight_in_last_round = 1e-9;

/* The rounding errors of where a window's unfolded source lies and of where rays cross edges, and of angle sums,
 * relative to the distances in question. If faces have a height below 1e-5 of their base, rounding errors can
 * exceed it. A last segment that is refused by mistake is found from a path; one that is accepted by mistake bends by
 * less than this. */
inline constexpr double unfolded_place_error = 1e-11;

/* Vertices at distance zero from a segment, relative to its length, as they are along degenerate faces: places are
 * summed over such faces and come from a rounded strip, with errors far below these 10^7 u. A vertex that is within
 * the tolerance of the end of an interval but does not touch the segment is examined as well: if its angles sum to
 * less than 2 pi, a shortest path is then reported as not straight. A vertex is missed only if errors exceed the
 * tolerance. */
inline constexpr double touched_vertex_tolerance = 1e-9;

/* Radians by which angles of edges of a triangulation that was flipped in double may be off. An edge that is not found
 * within this margin is measured by its own sequence of crossed edges, which takes longer. */
inline constexpr double near_leg_angle = 1e-8;

/* By what part a length in the triangulation may be off from the length measured from the input. Another geodesic to
 * the same vertex is mistaken for the edge if it crosses equally many edges and differs by less than this in length
 * and by less than `near_leg_angle` in direction. The measured angle is then off by at most that angle. */
inline constexpr double near_leg_length = 1e-9;

/* By what part of the distance a path of a tree is longer than before when flips around a wedge were in vain. Far
 * above `length_sum_rounding`, so that rounding errors alone are never taken for it. The wedge is left out from then
 * on. */
inline constexpr double visible_lengthening = 1e-10;

/* Directions at a vertex, relative to the sum of its angles, of which rounding may lead out of the surface. */
inline constexpr double direction_rounding = 1e-12;

/* Sines of angles between a direction and the border: a direction off the surface by at most the first, or into it by
 * at most the second, runs along the border. The second is 90 u, errors of a sine; directions off the surface have
 * been computed from sums of angles. */
inline constexpr double off_border = 1e-12, into_border = 1e-14;

/* The determinant of two adjacent faces, relative to its terms, below which the faces bend by hardly more than
 * rounding errors. Then a sum of angles is not unrolled into a plane but left to vectors. Both are exact, so that it
 * affects speed only. */
inline constexpr double flat_bend = 0x1p-30;

/* The length of a sum of unit vectors below which they cancel, and no direction is prescribed. Rounding errors leave
 * some u of each; a sum so short has no direction that is worth following. */
inline constexpr double canceled_directions = 1e-6;

/* A reversal of a curve: the square of the sum of two unit tangents, or one plus their cosine. Tangents
 * are then opposite up to 1.5e-6 radians; above, their sum has ten digits. Affects the shape of tubes only. */
inline constexpr double reversal = 1e-12;

/* The doubled area of a triangle of a map, over the square of the longest side, below which it is taken to be a line,
 * as behind a vertex at which paths bend. Positions there have errors of up to `unfolded_place_error`. */
inline constexpr double least_map_height = 1e-9;

/* If the sum of the angles of a sector is within this of 60 degrees, the order of summation would decide whether it
 * is sharp; then each of its corners decides for itself. */
inline constexpr double sharp_sector_margin = 1e-9;

/* Radians from 2 pi within which the sum of the angles at a vertex is computed exactly: far more than rounding errors,
 * and far less than pi, since the exact computation determines the sum only up to multiples of pi. */
inline constexpr double near_full_turn = 1e-3;

/* Border edges so close, relative to their length, are reported as nearly coincident: six digits are the default of
 * streams and of printf. */
inline constexpr double near_border_distance = 1e-6;

/* Lengths of paths over windows that differ by less count as equal, relative to them: 180 u. On needle-shaped faces
 * errors of positions can exceed it; then windows are kept that could be dropped. Too large a value drops a path that
 * is shorter by no more than that part. */
inline constexpr double equal_paths = 2e-14;

/* Windows whose ray to the apex misses them by more than this part of the side do not reach it; their paths are not
 * measured. This is a filter for speed: what it passes is decided by the lengths of paths. */
inline constexpr double beside_window = 1e-9;

/* The height of a face over its base, below which rays can be lost in rounding errors: errors of positions of 2^-46
 * move a ray by 1e-4 of such a face. Distances over flatter faces are computed, but not reported as confirmed. */
inline constexpr double flat_face = 1e-10;

/* The height over the length of a side that a degenerate face is given, so that rays pass it: far below u, so that
 * it does not show in any distance. */
inline constexpr double least_face_height = 0x1p-60;

/* The height of a face over its base, below which the place where a ray meets the opposite side does not determine its
 * direction: the side is taken to be visible as a whole, which adds windows and never makes a distance too short. */
inline constexpr double thin_face = 1e-12;

/* Radians; the error of a sum of angles around a vertex of up to some thousand faces. It lets a path bend at a vertex
 * whose angle is less than pi by so much, towards more windows. */
inline constexpr double angle_sum_rounding = 1e-12;

/* Less than every sum of angles around a vertex, if it is negated: directions beyond a border. */
inline constexpr double beyond_all_angles = 1e100;

/* The cosine between a line and a side, below which no ray perpendicular to the line leaves through the side, other
 * than by rounding errors of the line's direction: 9 u. */
inline constexpr double perpendicular = 1e-15;

/* The offset of a source, relative to the sides of its face, above which rounding errors of distances exceed 10^-6 of
 * a side and hide the place of the source in its face. A larger offset is refused with an exception. */
inline constexpr double greatest_offset = 1e10;

/* Rays of two windows over the same part of an edge are the same if their cosines with the edge differ by less: 10^5
 * u. Cosines of rays that graze the edge differ by the square of the angle between them only, so such rays are
 * mistaken for the same up to some 10^-6 radians; one window is dropped then, and distances behind it are too long by
 * up to the square of that angle, as a part of the path. */
inline constexpr double parallel_rays = 1e-11;

/* By how much the source of a window moves, relative to the size of its frame, when the window is carried over a face:
 * five changes of direction, the rotation, and the errors of the face itself are at most 32 rounded operations. */
inline constexpr double window_step_error = rounding_errors(32);

/* The error of positions on an edge, relative to the size of the frame of a window: that of four faces. In a longer
 * strip of faces of that size the path is longer as well. */
inline constexpr double window_place_error = 4 * window_step_error;

/* A distance of a field is accurate if the bound on its rounding errors is at most this part of it. The bound exceeds
 * the errors by several orders of magnitude on most meshes. */
inline constexpr double accurate_distance = 1e-10;

/* A point of a face so close to the edge through which its path comes, relative to the edge, that the direction of the
 * path is that of the ray and not that of the difference of two places, which has fewer than ten digits there. */
inline constexpr double near_edge_of_face = 1e-6;

/* The lengths of a path by a window and of one by way of a vertex, as a query computes them, count as equal if they
 * differ by less: 900 u, as the second is a sum of lengths. */
inline constexpr double equal_query_paths = 1e-13;

/* Radians between the ends of two paths of one length that may be one path, found twice. Affects what is reported of
 * ties only. */
inline constexpr double same_path_angle = 1e-6;

/* The difference of the lengths of two paths, relative to them, within which they tie: 2^11 u, for paths of some
 * hundred steps. Affects what is reported of ties only. */
inline constexpr double path_tie = rounding_errors(1 << 11);

/* The sine of an angle around a vertex that counts as 2 pi, so that paths may pass the vertex: more windows, never
 * fewer. */
inline constexpr double full_turn_tolerance = 1e-9;

/* Radians, and parts of the length of a line, by which the line may pass a vertex and still be taken to go through it,
 * while it is traced in a triangulation whose lengths have drifted. A line that gets lost is left to another method. */
inline constexpr double straight_leg = 1e-9;

/* Radians by which directions in such a triangulation may be off before the direction is measured from the input. */
inline constexpr double outgoing_halfedge_drift = 1e-6;

/* The error of each coordinate of a point inside a face, relative to the sum of the coordinate of a corner and its
 * differences to the others: one rounding of the difference, three of its weight, one of their product and up to three
 * of the sums. */
inline constexpr double combined_place_error = rounding_errors(8);

/* A lower bound on a distance on the surface by one in space between points of a metric: fewer than 32 rounded
 * operations. */
inline constexpr double space_bound_rounding = rounding_errors(32);

/* The error of the lower bound that a cone gives, per face that a path crosses, relative to the longest path of
 * interest: 2^7 u, for about as many operations. It is taken off every bound that is returned. */
inline constexpr double cone_error = rounding_errors(1 << 7);

/* How far below the line between its ends, as a part of the edge, a cone's value has to be, for the cone to be
 * determined by it. Without a cone, the lowest one is taken, which is a lower bound as well. */
inline constexpr double cone_sag_rounding = 1e-12;

/* The enlargement of the part of an edge that a cone covers, and the overlap of two cones there, as parts of the edge.
 * A larger value makes lower bounds smaller, never wrong. */
inline constexpr double cone_enlargement = 1e-6, cone_overlap = 1e-5;

/* The rounding errors of distances along edges, up to 10^9 of them, in the radius of a component. */
inline constexpr double landmark_radius_rounding = 0x1p-20;

// ---- Tuning of algorithms and stopping criteria

/* The accumulated error of lower bounds, relative to the longest path of interest, above which the propagation is
 * given up for other bounds. Speed only. */
inline constexpr double largest_cone_error = 1e-2;

/* Fitting of cones, both in parts of the possible range and found by measurement: by how much a cone is lowered at
 * first if it is too high in the middle, and the deviation from which on an edge gets a second cone. The cones are
 * lower bounds for any values. Speed only. */
inline constexpr double least_cone_lift = 3e-3, least_cone_sag = 3e-2;

/* Angles, in radians, that the initial straightening leaves to FlipOut, which ends with exact or rounded predicates. */
inline constexpr double unstraightened_angle = 1e-7;

/* Angles, in radians, that the funnel does not distinguish in double and decides by exact predicates instead. */
inline constexpr double unfunneled_angle = 1e-9;

/* The relative error of a vector with an error bound from which on its face is recomputed from the input. Speed only:
 * predicates that the bound leaves open are decided exactly. */
inline constexpr double inaccurate_vector = 0x1p-14;

/* By what part of its length a search for shortest paths of a class goes beyond the longest path, so that bounds there
 * are of use; and the gap between a length and its lower bound, as a part of the length, that is worth a search for a
 * shorter path. */
inline constexpr double class_search_margin = 0x1p-5, class_large_gap = 0x1p-4;

/* The accuracy of roots of a function along a side of a triangle, relative to its values: 900 u. */
inline constexpr double root_precision = 1e-13;

/* Tolerances of curves below this part of the longest side, 90 u, are lost in the rounding of weights, and refused. */
inline constexpr double least_curve_tolerance = 1e-14;

/* The relative change of energy in a step at which the iteration for a direction field has converged, and the shift,
 * relative to the least eigenvalue's order 1 / area, that makes its matrix definite. */
inline constexpr double converged_energy = 1e-12, eigenvalue_shift = 1e-6;

/* Added to each diagonal entry of a Hessian of order one, which may have empty rows where all faces are degenerate. */
inline constexpr double hessian_regularization = 1e-12;

/* The largest logarithm of a conformal factor, 10^9 or 10^-9, in absolute value. Beyond it, faces of a usual size are
 * smaller in the plane than the rounding errors of its coordinates. */
inline constexpr double largest_log_scale = 20.7;

/* The height of a face over a side that lies under a curve, relative to the side, below which the curve is moved onto
 * the opposite vertex before it is flattened: 10 sqrt(u), since the height of a degenerate face is computed as about
 * sqrt(u) from lengths with a relative error u. */
inline constexpr double passed_vertex_height = 1e-7;

/* Steps of a line search below these parts of the full step are not tried any more. */
inline constexpr double least_line_search_step = 1e-10, least_mean_step = 0x1p-40;

/* Computed distances of a triangle from a point are at least those of a box around it, less this part of the distance
 * of the farthest point of the box. Weights are not negative and sum to one within 3 u. A coordinate of the nearest
 * point errs by 8 u of that distance (a difference, a quotient, weights, three products and two sums), its distance by
 * 8 sqrt(3) u and 6 sqrt(3) u for the root of squares and the scale, which is 25 u; that of the box errs by less than
 * 6 u. */
inline constexpr double nearest_face_error = rounding_errors(64);

/* Vertices that curves add to a mesh are this part of the largest coordinate away from each other and from edges. Each
 * coordinate of (1 - t) a + t b has an error of at most three halves of an ulp, so a vertex is misplaced by less than
 * 1.5 sqrt(3) 2^-52 of the largest one; 2^-48 is three times what two vertices and an edge may come closer. */
inline constexpr double insertion_rounding = 0x1p-48;

// ---- Defaults and thresholds of the interface

inline constexpr double default_snap = 1e-12;                // of weights to edges and vertices
inline constexpr double nearest_point_snap = 1e-9;           // of weights, found by projection, to edges and vertices
inline constexpr double off_surface_tolerance = 1e-6;        // of the mesh's bounding box, for a point of a curve
inline constexpr double default_mollification = 1e-5;        // of the mean edge length
inline constexpr double default_angle_sum_tolerance = 1e-10; // radians, of a flattening
inline constexpr double default_mean_tolerance = 1e-11;      // of the root of the variance
inline constexpr double default_validity_tolerance = 1e-9;   // of the longest edge of a face
inline constexpr double default_tree_tolerance = 1e-10;      // of a path's length
inline constexpr double confirmed_gap = 1e-10;               // of a path's length, above its lower bound
inline constexpr double proven_gap = 1e-12;                  // of a path's length, above its lower bound
inline constexpr double reported_bend = 1e-8;                // radians, far above the error of a measured angle

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TOLERANCES_H
