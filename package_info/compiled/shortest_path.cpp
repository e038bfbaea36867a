// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE template
#include <CGAL/Flip_geodesics/shortest_path.h>
