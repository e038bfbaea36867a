// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_KEPT_INPUT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_KEPT_INPUT_H

#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <system_error>

/// Is the mesh of the first argument none of the files that the example writes? Otherwise says so.
inline bool is_input_kept(int argc, char** argv, std::initializer_list<const char*> results)
{
  std::error_code absent;
  for(const char* result : results)
    if(argc > 1 && std::filesystem::equivalent(argv[1], result, absent)) {
      std::cerr << "The result " << result << " would replace the mesh; rename it.\n";
      return false;
    }
  return true;
}

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_KEPT_INPUT_H
