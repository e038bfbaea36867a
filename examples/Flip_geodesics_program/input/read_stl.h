// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H

#include "input/scanners.h"
#include "input/soup.h"

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace program {

/*!
 * Reads an STL file, a text or binary. Points with equal coordinates are one vertex. Normals and the 16 free bits of a
 * binary triangle are passed over.
 *
 * A file is binary if its size is what its number of triangles requires, whatever its first word, and if its
 * first word is not `solid`.
 */
class Stl_reader
{
public:
  explicit Stl_reader(const Input_text& input)
    : m_input(input)
    , m_words(input)
  {
  }

  /// \throws Bad_input
  Soup read()
  {
    if(has_size_of_binary() || !is(m_words.next_word_of_text(), "solid"))
      read_binary();
    else
      read_text();
    return std::move(m_soup);
  }

private:
  static constexpr std::size_t size_of_header = 80, size_of_triangle = 50;

  // Whatever its case: some programs write all keywords in capitals.
  static bool is(std::string_view word, const char* keyword)
  {
    return boost::algorithm::iequals(word, keyword, std::locale::classic());
  }

  bool has_size_of_binary() const
  {
    const std::size_t size = m_input.bytes().size(), before = size_of_header + sizeof(std::uint32_t);
    if(size < before)
      return false;
    Byte_scanner bytes(m_input, size_of_header, boost::endian::order::little);
    return size - before == bytes.get<std::uint32_t>({"header field", 0}) * size_of_triangle;
  }

  void read_binary()
  {
    if(m_input.bytes().size() < size_of_header + sizeof(std::uint32_t))
      throw Bad_input(m_input.name() + ": the first word is not solid, and " + std::to_string(m_input.bytes().size()) +
                      " bytes are too few for a binary STL file; correct the file or its extension");
    Byte_scanner bytes(m_input, size_of_header, boost::endian::order::little);
    const std::size_t count = bytes.get<std::uint32_t>({"header field", 0});
    if(count > bytes.bytes_left() / size_of_triangle)
      bytes.fail("the header announces more triangles than the file contains; complete the file or, if it is a text "
                 "file, begin it with solid");
    while(m_soup.faces.size() < count) {
      const Element element = {"face", m_soup.faces.size()};
      bytes.skip(3 * sizeof(float), element); // the normal
      m_soup.faces.emplace_back();
      for(int i = 0; i < 3; ++i)
        add_corner([&] { return bytes.checked(static_cast<double>(bytes.get<float>(element)), element); });
      bytes.skip(sizeof(std::uint16_t), element);
    }
  }

  // Adds a corner to the last face. Points that are not finite are equal to none, and in no order.
  template <class Read>
  void add_corner(const Read& read_coordinate)
  {
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = read_coordinate();
    std::size_t v = m_soup.points.size();
    if(std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
      v = m_indices.try_emplace(x, v).first->second;
    if(v == m_soup.points.size())
      m_soup.points.emplace_back(x[0], x[1], x[2]);
    m_soup.faces.back().push_back(v);
  }

  // Solids, one after the other. The name of a solid, which is what is left of its line, may be any words. Between
  // facets words that are not known are passed over.
  void read_text()
  {
    bool is_in_solid = true;
    m_words.skip_line();
    for(std::string_view word; !(word = m_words.next_word_of_text()).empty();) {
      if(is_in_solid && is(word, "facet")) {
        read_facet();
      } else if(is(word, is_in_solid ? "endsolid" : "solid")) {
        is_in_solid = !is_in_solid;
        m_words.skip_line();
      } else if(!is_in_solid || is(word, "solid")) {
        m_words.fail("'" + printable(word) + "' is not expected here; remove it");
      }
    }
    if(is_in_solid)
      m_words.fail("the file ends without endsolid; complete it");
  }

  // Behind `facet`: the normal and `outer loop`, which are passed over, three vertices, `endloop` and `endfacet`.
  void read_facet()
  {
    const Element element = {"face", m_soup.faces.size()};
    m_soup.faces.emplace_back();
    std::string_view word = m_words.next_word_of_text();
    for(; !word.empty() && !is(word, "endfacet"); word = m_words.next_word_of_text()) {
      if(is(word, "vertex"))
        add_corner([&] { return m_words.number<double>(m_words.next_word_of_text(), element); });
      else if(is(word, "facet") || is(word, "endsolid"))
        m_words.fail(element, "has no endfacet; complete it");
    }
    if(word.empty())
      m_words.fail(element, "is cut off; complete it");
    if(m_soup.faces.back().size() != 3)
      m_words.fail(element, "has " + counted(m_soup.faces.back().size(), "vertex", "vertices") +
                                ", but all faces of an STL file are triangles; correct it");
  }

  const Input_text& m_input;
  Text_scanner m_words;
  Soup m_soup;
  std::map<std::array<double, 3>, std::size_t> m_indices; // of points
};

/// \throws Bad_input
inline Soup read_stl(const Input_text& input) { return Stl_reader(input).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H
