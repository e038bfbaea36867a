// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_BAD_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_BAD_INPUT_H

#include <stdexcept>

namespace program {

/// Input that the program cannot use; the message is one line with the position, the problem, and what to do.
class Bad_input : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_BAD_INPUT_H
