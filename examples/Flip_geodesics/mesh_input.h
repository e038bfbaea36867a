// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_MESH_INPUT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_MESH_INPUT_H

#include "memory_limit.h"
#include "program_mesh.h"
#include "soup_checks.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Reads the mesh of the program: anything that CGAL reads, as a soup first, so that an error can name its element and
// vertices keep the numbers that they have in the file.
namespace program {

/// The beginning of a text, on one line.
inline std::string printable(const std::string& text)
{
  std::string result;
  for(unsigned char c : text.substr(0, 100))
    result += std::isprint(c) != 0 ? static_cast<char>(c) : ' ';
  return result;
}

/// Catches what CGAL's readers print while it lives, so that an error stays one line.
class Captured_output
{
public:
  Captured_output()
    : m_err(std::cerr.rdbuf(m_text.rdbuf()))
    , m_out(std::cout.rdbuf(m_text.rdbuf()))
  {
  }
  Captured_output(const Captured_output&) = delete;
  Captured_output& operator=(const Captured_output&) = delete;
  ~Captured_output()
  {
    std::cerr.rdbuf(m_err);
    std::cout.rdbuf(m_out);
  }

  /// The last line that speaks of an error, in brackets; empty if there is none.
  std::string error() const
  {
    std::istringstream lines(m_text.str());
    std::string found;
    for(std::string line; std::getline(lines, line);)
      if(line.find("rror") != std::string::npos)
        found = " (" + printable(line) + ")";
    return found;
  }

private:
  std::ostringstream m_text;
  std::streambuf *m_err, *m_out;
};

inline std::size_t size_in_bytes(const std::string& file)
{
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if(!in || in.tellg() < 0)
    throw Bad_input(file + ": cannot be opened; check the path and its permissions");
  return static_cast<std::size_t>(in.tellg());
}

// CGAL's OFF reader makes room for as many elements as the header says before it reads the first one.
inline void check_off_header(const std::string& file, std::size_t bytes)
{
  std::ifstream in(file);
  std::string word, rest;
  while(in >> word && word[0] == '#')
    std::getline(in, rest);
  if(word.find("OFF") == std::string::npos)
    throw Bad_input(file +
                    ": the first word is not OFF, so that this is no OFF file; correct the file or its extension");
  while(in >> std::ws && in.peek() == '#')
    std::getline(in, rest);
  double vertices = 0, faces = 0;
  if(in >> vertices >> faces && (std::max)(vertices, faces) > static_cast<double>(bytes))
    throw Bad_input(file + ": the header promises more vertices or faces than " + std::to_string(bytes) +
                    " bytes can hold; correct the header");
}

// Can CGAL's reader read a vertex off this line of an OBJ file?
inline bool has_three_numbers(const std::string& line)
{
  std::istringstream words(line.substr(1));
  double coordinate = 0;
  for(int i = 0; i < 3; ++i)
    if(!(words >> coordinate) || !std::isfinite(coordinate))
      return false;
  return true;
}

// Gets a line of an OBJ file together with those that continue it, with blanks for tabs and none at its ends.
inline bool get_obj_line(std::istream& in, std::string& line, std::size_t& number)
{
  line.clear();
  for(std::string part; std::getline(in, part);) {
    ++number;
    std::replace(part.begin(), part.end(), '\t', ' ');
    line += part.substr(0, part.find_last_not_of(" \r") + 1);
    if(line.empty() || line.back() != '\\') {
      line.erase(0, line.find_first_not_of(' '));
      return true;
    }
    line.back() = ' ';
  }
  return !line.empty();
}

// The vertices and faces of an OBJ file. CGAL 5.5 does not get past keywords that it does not know, nor tabs and
// continued lines.
inline std::stringstream vertices_and_faces(const std::string& file)
{
  std::ifstream in(file);
  std::stringstream kept;
  std::string line;
  for(std::size_t number = 0; get_obj_line(in, line, number);) {
    if(std::any_of(line.begin(), line.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }))
      throw Bad_input(file + ": line " + std::to_string(number) +
                      " is not text, so that this is no OBJ file; correct it");
    const std::string keyword = line.substr(0, line.find(' '));
    if(keyword == "v" && !has_three_numbers(line))
      throw Bad_input(file + ": line " + std::to_string(number) +
                      " is a vertex without three finite numbers; correct it");
    if(keyword == "v" || keyword == "f")
      kept << line << '\n';
  }
  return kept;
}

inline bool read_with_cgal(const std::string& file, Soup& soup)
{
  const auto verbose = CGAL::parameters::verbose(true);
  if(extension(file) == "obj") {
    std::stringstream in = vertices_and_faces(file);
    return CGAL::IO::read_OBJ(in, soup.points, soup.faces, verbose);
  }
#ifdef CGAL_USE_VTK
  if(extension(file) == "vtp")
    return CGAL::IO::read_VTP(file, soup.points, soup.faces, verbose);
#endif
  return CGAL::IO::read_polygon_soup(file, soup.points, soup.faces, verbose);
}

inline void check_format(const std::string& file)
{
  std::vector<std::string> known = {"off", "obj", "ply", "stl", "ts"};
#ifdef CGAL_USE_VTK
  known.push_back("vtp");
#endif
  if(std::find(known.begin(), known.end(), extension(file)) != known.end())
    return;
  std::string list;
  for(const std::string& format : known)
    list += " ." + format;
  throw Bad_input(file + ": the format is not known by the extension; convert the mesh to one of" + list);
}

/// Reads a mesh as it is in the file. \throws Bad_input
inline Soup read_soup(const std::string& file)
{
  const std::size_t bytes = size_in_bytes(file);
  check_format(file);
  if(bytes == 0)
    throw Bad_input(file + ": the file is empty; give a triangle mesh");
  if(extension(file) == "off")
    check_off_header(file, bytes);
  Soup soup;
  bool is_read = false;
  std::string why;
  const char* too_many = " (it announces more elements than it has room for)";
  try {
    constexpr std::size_t base = std::size_t(1) << 30, factor = 100; // meshes in memory are up to 20 times their files
    const Memory_limit limit(base + factor * bytes);
    const Captured_output captured;
    is_read = read_with_cgal(file, soup);
    why = captured.error();
  } catch(const Bad_input&) {
    throw;
  } catch(const std::bad_alloc&) {
    why = too_many;
  } catch(const std::length_error&) {
    why = too_many;
  } catch(const std::exception& error) {
    why = " (" + printable(error.what()) + ")";
  }
  const bool is_empty_obj = extension(file) == "obj" && soup.faces.empty() && why.empty(); // said below, as for others
  if(!is_read && !is_empty_obj)
    throw Bad_input(file + ": not a valid ." + extension(file) + " file" + why +
                    "; check it, or convert it with another program");
  return soup;
}

/// Reads an oriented manifold triangle mesh. \throws Bad_input with one line that names the file and the element
inline Mesh read_mesh(const std::string& file)
{
  const Soup soup = read_soup(file);
  try {
    check_soup(soup);
  } catch(const Bad_input& error) {
    throw Bad_input(file + ": " + error.what());
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  if(mesh.number_of_faces() != soup.faces.size())
    throw Bad_input(file + ": the faces do not form an oriented manifold; repair the mesh");
  return mesh;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_MESH_INPUT_H
