// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_TEST_SCALE_H
#define FLIP_GEODESICS_TEST_TEST_SCALE_H

namespace Flip_geodesics_test {

/// How many times as many random cases the long tests look at.
#ifdef FLIP_GEODESICS_LONG_TESTS
constexpr int scale = 50;
#else
constexpr int scale = 1;
#endif

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_TEST_SCALE_H
