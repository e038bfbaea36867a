// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H

#include "input/byte_scanner.h"
#include "input/soup.h"
#include "input/text_scanner.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cstddef>
#include <cstdint>
#include <locale>
#include <string>
#include <string_view>
#include <vector>

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
    return m_soup.release();
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
    return size - before == bytes.get<std::uint32_t>({"header", 0}) * size_of_triangle;
  }

  void read_binary()
  {
    if(m_input.bytes().size() < size_of_header + sizeof(std::uint32_t))
      throw Bad_input(m_input.name() + ": the first word is not solid, and " + std::to_string(m_input.bytes().size()) +
                      " bytes are too few for a binary STL file; correct the file or its extension");
    Byte_scanner bytes(m_input, size_of_header, boost::endian::order::little);
    const std::size_t count = bytes.get<std::uint32_t>({"header", 0});
    if(count > bytes.bytes_left() / size_of_triangle)
      bytes.fail("the header announces more triangles than the file contains; complete the file or, if it is a text "
                 "file, begin it with solid");
    for(std::size_t f = 0; f < count; ++f) {
      const Element element = {"face", f};
      bytes.skip(3 * sizeof(float), element); // the normal
      std::vector<std::size_t> face;
      for(int i = 0; i < 3; ++i) {
        const double x = bytes.coordinate<float>(element), y = bytes.coordinate<float>(element),
                     z = bytes.coordinate<float>(element);
        face.push_back(m_soup.add_point(Soup::Point_3(x, y, z)));
      }
      m_soup.add_face(face);
      bytes.skip(sizeof(std::uint16_t), element);
    }
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
    const Element element = {"face", m_soup.number_of_faces()};
    std::vector<std::size_t> face;
    std::string_view word = m_words.next_word_of_text();
    for(; !word.empty() && !is(word, "endfacet"); word = m_words.next_word_of_text()) {
      if(is(word, "vertex"))
        face.push_back(read_vertex(element));
      else if(is(word, "facet") || is(word, "endsolid"))
        m_words.fail(element, "has no endfacet; complete it");
    }
    if(word.empty())
      m_words.fail(element, "is cut off; complete it");
    if(face.size() != 3)
      m_words.fail(element, "has " + std::to_string(face.size()) +
                                " vertices, but all faces of an STL file are triangles; "
                                "correct it");
    m_soup.add_face(face);
  }

  std::size_t read_vertex(const Element& face)
  {
    double x[3];
    for(double& coordinate : x)
      coordinate = m_words.number<double>(m_words.next_word_of_text(), face);
    return m_soup.add_point(Soup::Point_3(x[0], x[1], x[2]));
  }

  const Input_text& m_input;
  Text_scanner m_words;
  Soup_of_triangles m_soup;
};

/// \throws Bad_input
inline Soup read_stl(const Input_text& input) { return Stl_reader(input).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_STL_H
