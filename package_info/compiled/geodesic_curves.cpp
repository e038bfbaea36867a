// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_FLIP_GEODESICS_CURVES_INSTANCE template
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
