// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does not compile with options for which doubles are not those of IEEE 754.

#include <CGAL/Flip_geodesics/Descriptors.h>
