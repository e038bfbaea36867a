// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE template
#include <CGAL/Flip_geodesics/geodesic_distances.h>
