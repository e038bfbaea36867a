// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE template
#include <CGAL/Flip_geodesics/curves_through_points.h>
