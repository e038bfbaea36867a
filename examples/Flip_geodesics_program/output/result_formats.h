// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H

#include "bad_input.h"
#include "file_name.h"
#include "output/run_files.h"
#include "printable.h"
#include "program_options.h"

#include <algorithm>
#include <string>
#include <vector>

// The formats of the results that are meshes.
namespace program {

/// The format of a mesh: that of the file's extension, `polylines` for `.polylines.txt`, or what is wanted on standard
/// output. Empty if the name is.
inline std::string result_format(const Options& options, const std::string& name)
{
  if(is_standard_output(name))
    return lower_case(options.output_format);
  const std::string polylines = ".polylines.txt";
  const bool are_polylines =
      name.size() > polylines.size() && name.compare(name.size() - polylines.size(), polylines.size(), polylines) == 0;
  return are_polylines ? "polylines" : extension(name);
}

inline void check_result_format(const Options& options, const std::string& option, const std::string& name,
                                const std::vector<std::string>& known)
{
  if(name.empty() || std::find(known.begin(), known.end(), result_format(options, name)) != known.end())
    return;
  std::string formats;
  for(const std::string& format : known)
    formats += ' ' + format;
  throw Bad_input(is_standard_output(name)
                      ? "--output-format tells the format of " + option + " on standard output; give one of" + formats
                      : printable(name) + ": the extension tells the format of " + option + "; use one of" + formats);
}

/// \throws Bad_input
inline void check_formats_of_results(const Options& options)
{
  const Result_names& names = options.results;
  const std::vector<std::string> meshes = {"off", "obj", "ply", "stl", "vtp"};
  check_result_format(options, "--mesh", names.viewer, {"obj", "ply", "vtp", "glb", "polylines"});
  check_result_format(options, "--subdivision", options.meshes.subdivision, meshes);
  check_result_format(options, "--insert", options.meshes.insertion, meshes);
  check_result_format(options, "--cut", options.meshes.cut, meshes);
  check_result_format(options, "--repaired", names.repaired, meshes);
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H
