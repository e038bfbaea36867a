// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H

#include "file_name.h"
#include "messages.h"
#include "output/run_files.h"
#include "program_options.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// The formats of the results that are meshes, and names that do not fit a result.
namespace program {

/// The format of a mesh: that of the file's extension, `polylines` for `.polylines.txt`, or what is wanted on standard
/// output. Empty if the name is.
inline std::string result_format(const Options& options, const std::string& name)
{
  if(is_standard_output(name))
    return options.output_format;
  return is_name_of_polylines(name) ? "polylines" : extension(name);
}

/// Gives those of `--output` that are not meshes to the options for them, by their formats. \throws Bad_input
inline void sort_outputs(Options& options)
{
  Result_names& names = options.results;
  const bool has_curves = options.command != "repair" && options.command != "flatten";
  std::vector<std::string> meshes;
  for(const std::string& name : names.outputs) {
    const std::string format = result_format(options, name);
    std::string* const place = format == "json"                 ? &names.json
                               : has_curves && format == "csv"  ? &names.stats
                               : has_curves && format == "html" ? &names.page
                                                                : nullptr;
    if(place == nullptr)
      meshes.push_back(name);
    else if(place->empty())
      *place = name;
    else
      throw Bad_input(name_of_result(name) + ": another result has the format " + format +
                      "; use only one in this format");
  }
  names.outputs = meshes;
  if(!names.page.empty() && options.threads > 1) // the page shows the steps of the curves one after the other
    throw Bad_input("--threads and the page " + printable(names.page) + " cannot be combined; use one of them");
}

inline void check_result_format(const Options& options, const std::string& option, const std::string& name,
                                const std::vector<std::string>& known)
{
  if(name.empty() || std::find(known.begin(), known.end(), result_format(options, name)) != known.end())
    return;
  std::string formats;
  for(const std::string& format : known)
    formats += (formats.empty() ? " " : ", ") + format + (format == "polylines" ? ".txt" : "");
  throw Bad_input(is_standard_output(name)
                      ? "--output-format determines the format of " + option + " on standard output" +
                            (options.format.empty() ? "" : ", and --format that of the mesh") + "; use one of" + formats
                      : printable(name) + ": the extension determines the format of " + option + "; use one of" +
                            formats);
}

/// Refuses names with which a page or a file of lines would replace a mesh by a slip in the command line.
/// \param use the extension to use instead \throws Bad_input
inline void check_extension(const std::string& option, const std::string& name, const std::string& use)
{
  static const std::vector<std::string> others = {"html", "htm", "off", "obj", "ply", "stl", "ts", "vtp", "glb"};
  if(name.empty() || open_file(name) || is_special_file(name))
    return;
  const auto place = std::find(others.begin(), others.end(), extension(name)) - others.begin();
  if(use == ".html" && place > 1)
    throw Bad_input(printable(name) + ": " + option + " writes a page; use a name that ends in .html");
  if(use != ".html" && place < static_cast<std::ptrdiff_t>(others.size()))
    throw Bad_input(printable(name) + ": " + option + " writes lines of text; use a name that ends in " + use);
}

/// \throws Bad_input
inline void check_formats_of_results(const Options& options)
{
  const Result_names& names = options.results;
  const std::vector<std::string> meshes = {"off", "obj", "ply", "stl", "vtp"};
  std::vector<std::string> of_outputs = {"obj", "ply", "vtp", "glb", "polylines", "csv", "html"};
  if(options.command == "repair")
    of_outputs = meshes;
  else if(options.command == "flatten")
    of_outputs = {"obj", "glb"};
  of_outputs.push_back("json"); // like csv and html, of the options that `sort_outputs()` gives it to
  for(const std::string& name : names.outputs)
    check_result_format(options, "--output", name, of_outputs);
  const auto has_output_in = [&](const std::vector<std::string>& formats) {
    return std::any_of(names.outputs.begin(), names.outputs.end(), [&](const std::string& name) {
      return std::find(formats.begin(), formats.end(), result_format(options, name)) != formats.end();
    });
  };
  if(names.has_values && !has_output_in({"ply", "vtp"}) && names.json.empty())
    throw Bad_input("--values requires a .ply, .vtp or .json file; use --output with one of these extensions");
  if(names.tubes && !has_output_in({"obj", "ply", "vtp", "glb"}))
    throw Bad_input("--tubes requires an .obj, .ply, .vtp or .glb file; use --output with one of these extensions");
  check_result_format(options, "--subdivision", options.meshes.subdivision, meshes);
  check_result_format(options, "--insert", options.meshes.insertion, meshes);
  check_result_format(options, "--cut", options.meshes.cut, meshes);
  check_extension("--page", names.page, ".html");
  check_extension("--output", names.live, ".html");
  check_extension("--polylines", names.polylines, ".txt");
  check_extension("--stats", names.stats, ".csv");
  check_extension("--map", names.map, ".csv");
  check_extension("--matrix", names.matrix, ".csv");
  check_extension("--json", names.json, ".json");
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FORMATS_H
