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

/// One in so many cases is looked at where the standard library checks, for instance, all of a heap for each change, or
/// a sanitizer checks each access.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) // as clang++ says it
#define FLIP_GEODESICS_TEST_SANITIZED
#endif
#endif
#if defined(_GLIBCXX_DEBUG) || defined(__SANITIZE_ADDRESS__) || defined(FLIP_GEODESICS_TEST_SANITIZED)
constexpr int stride = 5;
#else
constexpr int stride = 1;
#endif

/// Whether cases that take seconds to run or to compile are among the others of their kind. With shared instances, in
/// the builds that a change is tested with each time, they are not.
#ifdef FLIP_GEODESICS_TEST_ALL_CASES
constexpr bool has_all_cases = true;
#else
constexpr bool has_all_cases = false;
#endif

/// One in so many cases is looked at where there are hundreds of a kind.
constexpr int stride_of_many = has_all_cases ? stride : 5;

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_TEST_SCALE_H
