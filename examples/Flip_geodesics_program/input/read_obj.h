// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_OBJ_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_OBJ_H

#include "input/scanners.h"
#include "input/soup.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace program {

/// The texture coordinates of the corners of the faces of a soup.
struct Texture
{
  std::vector<std::array<double, 3>> coordinates;
  std::vector<std::vector<std::size_t>> corners; ///< an index of `coordinates` for each corner of each face
};

/*!
 * Reads a Wavefront OBJ file: its lines `v`, `f` and, if the texture is wanted, `vt`; all others are passed over. A
 * face may have vertices that come after it.
 */
class Obj_reader
{
public:
  /// \param texture where the texture goes; null if it is not wanted
  explicit Obj_reader(const Input_text& input, Texture* texture)
    : m_words(input, '#', true)
    , m_name(input.name())
    , m_texture(texture)
  {
  }

  /// \throws Bad_input
  Soup read()
  {
    while(m_words.next_line()) {
      check_text();
      const std::string_view keyword = m_words.next_word();
      if(keyword == "v")
        read_vertex();
      else if(keyword == "vt" && m_texture != nullptr)
        read_texture_coordinates();
      else if(keyword == "f")
        read_face();
    }
    if(m_soup.points.empty() && m_soup.faces.empty())
      throw Bad_input(m_name + ": no line starts with `v` (a vertex) or `f` (a face), so this is not an OBJ file of a "
                               "surface; correct the file or its extension");
    if(m_last_vertex >= static_cast<long long>(m_soup.points.size()))
      throw Bad_input(m_error_at_last_vertex);
    check_unclean_vertices();
    return std::move(m_soup);
  }

private:
  void check_text() const
  {
    for(unsigned char c : m_words.rest_of_line())
      if(std::iscntrl(c) != 0 && c != '\t')
        m_words.fail(
            "the line has control characters, so the file is not an OBJ file; correct the file or its extension");
  }

  void read_vertex()
  {
    const Element element = {"vertex", m_soup.points.size()};
    std::array<double, 3> x;
    for(double& coordinate : x) {
      const std::string_view word = m_words.next_word();
      const std::size_t length = length_of_number(word);
      if(length > 0 && length < word.size())
        m_unclean.emplace_back(element.index, m_words.message(element, "has '" + printable(word) +
                                                                           "', which is not a number; correct it"));
      coordinate = m_words.number<double>(length > 0 ? word.substr(0, length) : word, element);
    }
    m_soup.points.emplace_back(x[0], x[1], x[2]);
  }

  // How much of a word std::from_chars() takes for a number.
  static std::size_t length_of_number(std::string_view word)
  {
    const std::size_t sign = word.substr(0, 1) == "+" ? 1 : 0;
    double ignored = 0;
    const auto [end, error] = from_chars(word.data() + sign, word.data() + word.size(), ignored);
    return error == std::errc::invalid_argument ? 0 : static_cast<std::size_t>(end - word.data());
  }

  // Numbers with something behind them matter only where a face uses the vertex. \throws Bad_input
  void check_unclean_vertices()
  {
    if(m_unclean.empty())
      return;
    std::vector<char> is_used(m_soup.points.size(), 0);
    for(const std::vector<std::size_t>& face : m_soup.faces)
      for(std::size_t v : face)
        is_used[v] = 1;
    for(const auto& [vertex, error] : m_unclean)
      if(is_used[vertex] != 0)
        throw Bad_input(error);
  }

  void read_texture_coordinates()
  {
    const Element element = {"texture coordinate", m_texture->coordinates.size()};
    std::array<double, 3> x = {0, 0, 0};
    x[0] = m_words.number<double>(m_words.next_word(), element);
    for(std::size_t i = 1; i < 3 && m_words.has_word(); ++i)
      x[i] = m_words.number<double>(m_words.next_word(), element);
    m_texture->coordinates.push_back(x);
  }

  // An index counts from 1, or backward from -1.
  static long long resolve(long long index, std::size_t count)
  {
    return index < 0 ? static_cast<long long>(count) + index : index - 1;
  }

  void read_face()
  {
    const Element element = {"face", m_soup.faces.size()};
    m_soup.faces.emplace_back();
    if(m_texture != nullptr)
      m_texture->corners.emplace_back();
    for(std::string_view word; !(word = m_words.next_word()).empty();) {
      const std::size_t slash = (std::min)(word.find('/'), word.size());
      read_vertex_of_face(word.substr(0, slash), element);
      if(m_texture != nullptr)
        read_corner(word.substr((std::min)(slash + 1, word.size())), element);
    }
  }

  void read_vertex_of_face(std::string_view word, const Element& face)
  {
    const char* const what = "has a vertex that is not one of those in the file; correct it";
    const long long v = resolve(m_words.number<long long>(word, face), m_soup.points.size());
    if(v < 0)
      m_words.fail(face, what);
    if(v >= static_cast<long long>(m_soup.points.size()) && v > m_last_vertex) {
      m_last_vertex = v;
      m_error_at_last_vertex = m_words.message(face, what);
    }
    m_soup.faces.back().push_back(static_cast<std::size_t>(v));
  }

  // What is behind the first slash: the texture coordinates, and after another slash the normal.
  void read_corner(std::string_view word, const Element& face)
  {
    const std::size_t count = m_texture->coordinates.size();
    long long index = 0;
    if(parse_number(word.substr(0, word.find('/')), index) != nullptr)
      index = 0;
    const long long corner = resolve(index, count);
    if(corner < 0 || corner >= static_cast<long long>(count))
      m_words.fail(face, "has a corner without a valid texture coordinate; add one to every corner of every face");
    m_texture->corners.back().push_back(static_cast<std::size_t>(corner));
  }

  Text_scanner m_words;
  std::string m_name; // of the file
  Texture* m_texture;
  Soup m_soup;
  std::vector<std::pair<std::size_t, std::string>> m_unclean; // vertices, each with an error for it
  long long m_last_vertex = -1;                               // of those that a face had before they came
  std::string m_error_at_last_vertex;
};

/// \throws Bad_input
inline Soup read_obj(const Input_text& input, Texture* texture = nullptr) { return Obj_reader(input, texture).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_OBJ_H
