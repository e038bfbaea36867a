// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_FLIP_GEODESICS_DEFINE_SHORTEST_PATH
#include <CGAL/Flip_geodesics/shortest_path.h>
