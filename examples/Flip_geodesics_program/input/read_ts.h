// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_TS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_TS_H

#include "input/scanners.h"
#include "input/soup.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace program {

/*!
 * Reads a triangulated surface of GOCAD: its lines `VRTX` or `PVRTX` with a number and coordinates, `ATOM` or `PATOM`
 * with a number and that of the vertex that it stands for, and `TRGL` with three such numbers. All others are passed
 * over, but `END` has to come. With several surfaces in a file numbers restart at each.
 */
class Ts_reader
{
public:
  explicit Ts_reader(const Input_text& input)
    : m_words(input)
    , m_name(input.name())
  {
  }

  /// \throws Bad_input
  Soup read()
  {
    bool is_ended = false, is_known = false;
    while(m_words.next_line()) {
      const std::string_view keyword = m_words.next_word();
      is_known = is_known || is_of_ts(keyword);
      if(keyword == "GOCAD")
        m_vertices.clear();
      else if(keyword == "VRTX" || keyword == "PVRTX")
        read_vertex();
      else if(keyword == "ATOM" || keyword == "PATOM")
        read_atom();
      else if(keyword == "TRGL")
        read_triangle();
      is_ended = keyword.empty() ? is_ended : keyword == "END";
    }
    if(!is_known)
      throw Bad_input(m_name + ": no line starts with GOCAD, VRTX or TRGL, so this is not a TS file; correct the file "
                               "or its extension");
    if(!is_ended)
      m_words.fail("the file ends without END; complete it");
    return std::move(m_soup);
  }

private:
  static bool is_of_ts(std::string_view keyword)
  {
    for(const char* known : {"GOCAD", "VRTX", "PVRTX", "ATOM", "PATOM", "TRGL"})
      if(keyword == known)
        return true;
    return false;
  }

  long long read_number(const Element& element) { return m_words.number<long long>(m_words.next_word(), element); }

  void add(long long number, std::size_t vertex)
  {
    if(!m_vertices.emplace(number, vertex).second)
      m_words.fail("the vertex number " + std::to_string(number) + " is already used by another vertex; correct it");
  }

  void read_vertex()
  {
    const Element element = {"vertex", m_soup.points.size()};
    add(read_number(element), element.index);
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = m_words.number<double>(m_words.next_word(), element);
    m_soup.points.emplace_back(x[0], x[1], x[2]);
  }

  std::size_t read_reference(const Element& element)
  {
    const auto found = m_vertices.find(read_number(element));
    if(found == m_vertices.end())
      m_words.fail(element, "refers to a vertex that no earlier line defines; correct it");
    return found->second;
  }

  // Each number is that of a place of its own in the list, though its point is that of another one.
  void read_atom()
  {
    const Element element = {"atom", m_vertices.size()};
    const long long number = read_number(element);
    add(number, read_reference(element));
  }

  void read_triangle()
  {
    const Element element = {"face", m_soup.faces.size()};
    m_soup.faces.emplace_back();
    for(int i = 0; i < 3; ++i)
      m_soup.faces.back().push_back(read_reference(element));
  }

  Text_scanner m_words;
  std::string m_name; // of the file
  Soup m_soup;
  std::unordered_map<long long, std::size_t> m_vertices; // by their numbers
};

/// \throws Bad_input
inline Soup read_ts(const Input_text& input) { return Ts_reader(input).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_TS_H
