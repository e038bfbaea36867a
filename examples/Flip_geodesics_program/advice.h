// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <exception>
#include <string>

namespace program {

/// Returns the message of an error; of a degenerate edge with other advice than the library's, which names its classes.
inline std::string with_advice(const std::exception& error, const std::string& advice)
{
  namespace FG = CGAL::Flip_geodesics;
  const auto* const degenerate = dynamic_cast<const FG::Degenerate_face_error*>(&error);
  if(degenerate == nullptr || degenerate->remedy() == FG::Degeneracy_remedy::NONE)
    return error.what();
  return degenerate->problem() + "; " + advice;
}

/// Returns the message of an error where neither contraction nor `--mollify` is available.
inline std::string with_advice_to_repair(const std::exception& error)
{
  return with_advice(error, "use --repair, which removes such edges");
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H
