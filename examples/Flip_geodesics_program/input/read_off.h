// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_OFF_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_OFF_H

#include "input/scanners.h"
#include "input/soup.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace program {

/*!
 * Reads an OFF file, as Geomview describes the format: an optional keyword `[ST][C][N][4][n]OFF`, with `BINARY` after
 * it or not; the numbers of vertices, faces and edges; the vertices and the faces, with or without colors, normals and
 * texture coordinates, which are passed over. With a 4 there is a fourth coordinate, by which the others are divided.
 *
 * In a text every vertex and face has its own line, and what is behind the vertices of a face is its color. A file that
 * is not like that is read by words: as many for each element as the keyword implies, and none for the color of a face.
 * If the vertices have lines of equally many words, but not of as many as the keyword implies, as colors of three
 * components have, words would mix up the vertices, and the lines alone count.
 */
class Off_reader
{
public:
  explicit Off_reader(const Input_text& input)
    : m_input(input)
    , m_words(input, '#')
  {
  }

  /// \throws Bad_input
  Soup read()
  {
    read_keyword();
    m_vertices = read_number_of("vertices");
    m_faces = read_number_of("faces");
    if(m_bytes) {
      m_bytes->skip(sizeof(std::int32_t), {"header field", 0}); // the number of edges is of no use
      return read_elements();
    }
    skip_number_of_edges();
    const Text_scanner start = m_words;
    m_is_by_lines = true;
    try {
      return read_elements();
    } catch(const Bad_input&) {
      if(are_lines_of_vertices_alike(start) && m_words_of_line != number_of_coordinates() + m_words_of_vertex)
        throw;
      m_words = start;
      m_is_by_lines = false;
      try {
        return read_elements();
      } catch(const Bad_input&) {
      }
      throw; // lines are the rule: their errors are more specific
    }
  }

private:
  // Takes a prefix off a word if it is there.
  static bool take(std::string_view& word, std::string_view prefix)
  {
    const bool is_there = word.substr(0, prefix.size()) == prefix;
    if(is_there)
      word.remove_prefix(prefix.size());
    return is_there;
  }

  void read_keyword()
  {
    const std::string_view first = m_words.next_word_of_text();
    std::string_view word = first;
    const bool has_texture = take(word, "ST"), has_color = take(word, "C"), has_normal = take(word, "N");
    m_is_homogeneous = take(word, "4");
    const bool has_dimension = take(word, "n");
    double number = 0;
    if(!take(word, "OFF")) {
      if(parse_number(first, number) != nullptr)
        m_words.fail("the first word, '" + printable(first) +
                     "', is not OFF, so this is not an OFF file; correct the file or its extension");
      word = first;
      m_is_homogeneous = false;
    }
    m_words.go_back(word.size());
    m_words_of_vertex = (has_normal ? 3 : 0) + (has_color ? 4 : 0) + (has_texture ? 2 : 0);
    if(has_dimension && m_words.next_word_of_text() != "3")
      m_words.fail("the vertices must have three coordinates; convert the mesh");
    const std::string_view next = m_words.next_word_of_text();
    if(next == "BINARY")
      m_bytes.emplace(m_input, m_words.next_position(), boost::endian::order::big);
    else
      m_words.go_back(next.size());
  }

  const Scanner& scanner() const { return m_bytes ? static_cast<const Scanner&>(*m_bytes) : m_words; }

  std::size_t read_number_of(const std::string& what)
  {
    long long number = 0;
    if(m_bytes) {
      number = m_bytes->get<std::int32_t>({"header field", 0});
    } else {
      const std::string_view word = m_words.next_word_of_text();
      if(const char* const error = parse_number(word, number))
        m_words.fail("the number of " + what + ", '" + printable(word) + "', " + error + "; correct the header");
    }
    if(number < 0 || static_cast<unsigned long long>(number) > m_input.bytes().size())
      m_words.fail("the header announces a number of " + what + " that a file of " +
                   std::to_string(m_input.bytes().size()) + " bytes cannot contain; correct the header");
    return static_cast<std::size_t>(number);
  }

  // The number of edges is of no use. Some files leave it out.
  void skip_number_of_edges()
  {
    Text_scanner after = m_words;
    const bool is_on_line = m_words.has_word();
    const std::string_view word = after.next_word_of_text();
    long long number = 0;
    if(!is_on_line && after.has_word())
      return;
    m_words = after;
    if(const char* const error = is_on_line ? parse_number(word, number) : nullptr)
      m_words.fail("the number of edges, '" + printable(word) + "', " + error + "; correct the header");
  }

  // Returns whether as many lines as there are vertices have equally many words, all of them numbers.
  bool are_lines_of_vertices_alike(Text_scanner words)
  {
    m_words_of_line = 0;
    for(std::size_t i = 0; i < m_vertices; ++i) {
      std::size_t count = 0;
      double number = 0;
      if(words.has_word() || !words.next_line_with_words())
        return false;
      for(std::string_view word; !(word = words.next_word()).empty(); ++count)
        if(parse_number(word, number) != nullptr)
          return false;
      if(i > 0 && count != m_words_of_line)
        return false;
      m_words_of_line = count;
    }
    return m_words_of_line >= number_of_coordinates();
  }

  // Goes to where the next vertex or face starts.
  Element start(const char* kind, std::size_t index)
  {
    const Element element = {kind, index};
    if(m_is_by_lines && m_words.has_word())
      m_words.fail(element, "does not start on a new line; insert a line break");
    if(m_is_by_lines && !m_words.next_line_with_words())
      m_words.fail(element, "is missing at the end of the file; complete the file, or correct the counts");
    return element;
  }

  // In a binary file, all numbers have four bytes.
  template <class T>
  T read_number(const Element& element)
  {
    if(m_bytes)
      return m_bytes->get<std::conditional_t<std::is_integral<T>::value, std::int32_t, float>>(element);
    return m_words.number<T>(m_is_by_lines ? m_words.next_word() : m_words.next_word_of_text(), element);
  }

  std::size_t read_size(const Element& element)
  {
    const long long size = read_number<long long>(element);
    if(size < 0)
      scanner().fail(element, "has a negative number of vertices or color components; correct it");
    return static_cast<std::size_t>(size);
  }

  // Passes over what is left of a line: colors and the like.
  void skip_line(const Element& element)
  {
    double number = 0;
    for(std::string_view word; !(word = m_words.next_word()).empty();)
      if(const char* const error = parse_number(word, number); error != nullptr && std::isfinite(number))
        m_words.fail(element, "is followed by '" + printable(word) + "', which " + error + "; correct it");
  }

  void read_vertex(Soup& soup)
  {
    const Element element = start("vertex", soup.points.size());
    std::array<double, 4> x = {0, 0, 0, 1};
    for(std::size_t i = 0; i < number_of_coordinates(); ++i)
      x[i] = scanner().checked(read_number<double>(element), element);
    if(x[3] == 0)
      scanner().fail(element, "lies at infinity because its fourth coordinate is 0; correct it");
    for(std::size_t i = 0; i < 3; ++i) {
      x[i] /= x[3];
      if(!std::isfinite(x[i]) && !m_input.may_have_points_not_finite())
        scanner().fail(element, "has a coordinate that exceeds the range of doubles; correct it");
    }
    soup.points.emplace_back(x[0], x[1], x[2]);
    if(m_is_by_lines)
      return skip_line(element);
    for(std::size_t i = 0; i < m_words_of_vertex; ++i)
      read_number<double>(element);
  }

  // In a binary file, the number of components of its color is behind a face.
  void read_face(Soup& soup)
  {
    const Element element = start("face", soup.faces.size());
    soup.faces.emplace_back();
    for(std::size_t left = read_size(element); left > 0; --left) {
      const long long v = read_number<long long>(element);
      if(v < 0 || static_cast<unsigned long long>(v) >= m_vertices)
        scanner().fail(element, "has a vertex that is not one of the " + std::to_string(m_vertices) +
                                    " in the file; correct it");
      soup.faces.back().push_back(static_cast<std::size_t>(v));
    }
    if(m_is_by_lines)
      skip_line(element);
    if(m_bytes)
      m_bytes->skip(sizeof(float) * read_size(element), element);
  }

  Soup read_elements()
  {
    Soup soup;
    soup.points.reserve(m_vertices);
    while(soup.points.size() < m_vertices)
      read_vertex(soup);
    while(soup.faces.size() < m_faces)
      read_face(soup);
    if(!m_bytes && !m_words.next_word_of_text().empty())
      m_words.fail("there is text after the last face; remove it, or correct the counts");
    return soup;
  }

  std::size_t number_of_coordinates() const { return m_is_homogeneous ? 4 : 3; }

  const Input_text& m_input;
  Text_scanner m_words;
  std::optional<Byte_scanner> m_bytes; // of a binary file, behind the keyword
  bool m_is_homogeneous = false, m_is_by_lines = false;
  std::size_t m_words_of_vertex = 0; // behind its coordinates, as the keyword implies
  std::size_t m_words_of_line = 0;   // of a vertex, as the file has it
  std::size_t m_vertices = 0, m_faces = 0;
};

/// \throws Bad_input
inline Soup read_off(const Input_text& input) { return Off_reader(input).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_OFF_H
