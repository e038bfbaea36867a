// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H

#include "input/scanners.h"
#include "input/soup.h"
#include "messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace program {

/// A type of numbers in PLY files.
struct Ply_type
{
  std::string_view name, other_name;
  std::size_t size; ///< in bytes
  bool is_integer;
  double least, greatest;
  double (*read)(Byte_scanner&, const Element&);
};

template <class T>
constexpr Ply_type ply_type(std::string_view name, std::string_view other_name)
{
  using Limits = std::numeric_limits<T>;
  return {name,
          other_name,
          sizeof(T),
          Limits::is_integer,
          static_cast<double>(Limits::lowest()),
          static_cast<double>((Limits::max)()),
          [](Byte_scanner& bytes, const Element& element) { return static_cast<double>(bytes.get<T>(element)); }};
}

/*!
 * Reads a PLY file, a text or binary: `x`, `y`, `z` of its vertices and the list `vertex_indices`, or `vertex_index`,
 * of its faces, of any types. All else is passed over. Coordinates are rounded to their type, in a text as in a binary
 * file; a remark is printed if digits are lost.
 */
class Ply_reader
{
public:
  explicit Ply_reader(const Input_text& input)
    : m_input(input)
    , m_words(input)
  {
  }

  /// \throws Bad_input
  Soup read()
  {
    read_header();
    for(const Element_kind& kind : m_elements) {
      if(kind.is_vertex())
        read_vertices(kind);
      else if(kind.is_face())
        read_faces(kind);
      else
        for(std::size_t i = 0; i < kind.count && !kind.properties.empty(); ++i)
          for(const Property& property : kind.properties)
            skip(property, {"other element", i});
    }
    if(m_bytes ? !m_bytes->is_at_end() : !m_words.next_word_of_text().empty())
      scanner().fail("there is data after the last element; remove it, or correct the header");
    if(m_rounded > 0)
      m_soup.remarks.push_back(m_first_rounded +
                               " has more digits than the type float of the header can store, and was rounded; in "
                               "total " +
                               counted(m_rounded, "coordinate was", "coordinates were") +
                               " rounded; declare the type double to keep all digits");
    return std::move(m_soup);
  }

private:
  struct Property
  {
    std::string name;
    const Ply_type *type, *type_of_size; // the latter null unless it is a list
  };

  struct Element_kind
  {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;

    bool is_vertex() const { return name == "vertex" || name == "vertices"; }
    bool is_face() const { return name == "face" || name == "faces"; }

    std::array<std::size_t, 3> coordinates() const { return {find("x"), find("y"), find("z")}; }
    std::size_t corners() const { return (std::min)(find("vertex_indices"), find("vertex_index")); }

    // The position of a property among others; their number if there is none of that name.
    std::size_t find(std::string_view property) const
    {
      const auto found =
          std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == property; });
      return static_cast<std::size_t>(found - properties.begin());
    }
  };

  const Scanner& scanner() const { return m_bytes ? static_cast<const Scanner&>(*m_bytes) : m_words; }

  // From `ply` to `end_header`. Lines without a keyword, some programs write as comments.
  void read_header()
  {
    if(!m_words.next_line() || m_words.next_word() != "ply")
      m_words.fail("the first word is not ply, so this is not a PLY file; correct the file or its extension");
    const std::string_view format = next_keyword() == "format" ? m_words.next_word() : "";
    if(format.empty() || m_words.next_word() != "1.0")
      m_words.fail("the format is missing, or its version is not 1.0; correct the header");
    const bool is_big = format == "binary_big_endian";
    if(!is_big && format != "binary_little_endian" && format != "ascii")
      m_words.fail("the format '" + printable(format) +
                   "' is not known; use ascii, binary_little_endian or binary_big_endian");
    for(std::string_view keyword; (keyword = next_keyword()) != "end_header";) {
      if(keyword == "element")
        read_element();
      else if(keyword == "property")
        read_property();
    }
    for(const Element_kind& kind : m_elements)
      check(kind);
    if(format != "ascii")
      m_bytes.emplace(m_input, start_of_bytes(), is_big ? boost::endian::order::big : boost::endian::order::little);
  }

  void check(const Element_kind& kind) const
  {
    const auto is_number = [&](std::size_t place) {
      return place < kind.properties.size() && kind.properties[place].type_of_size == nullptr;
    };
    const auto places = kind.coordinates();
    if(kind.is_vertex() && !std::all_of(places.begin(), places.end(), is_number))
      m_words.fail("the vertices do not have the properties x, y and z; correct the header");
    const std::size_t corners = kind.corners();
    if(kind.is_face() &&
       (corners == kind.properties.size() || is_number(corners) || !kind.properties[corners].type->is_integer))
      m_words.fail("the faces do not have a property vertex_indices that is a list of integers; correct the header");
    if(kind.name == "tristrips")
      m_words.fail("the file has triangle strips, which are not supported; write faces instead");
  }

  // The first word of the next line that is not a comment.
  std::string_view next_keyword()
  {
    while(m_words.next_line_with_words()) {
      const std::string_view keyword = m_words.next_word();
      if(keyword != "comment" && keyword != "obj_info")
        return keyword;
    }
    m_words.fail("the file ends before end_header; complete it");
  }

  // If lines end with CR alone, an LF behind the header is a number's.
  std::size_t start_of_bytes() const
  {
    const std::size_t first_end = m_input.bytes().find_first_of("\r\n"), start = m_words.next_position();
    const bool has_cr_alone =
        m_input.bytes().substr(first_end, 1) == "\r" && m_input.bytes().substr(first_end, 2) != "\r\n";
    return has_cr_alone ? m_input.bytes().rfind('\r', start - 1) + 1 : start;
  }

  void read_element()
  {
    const std::string name(m_words.next_word());
    const std::string_view word = m_words.next_word();
    long long count = 0;
    const char* const error = parse_number(word, count);
    if(error != nullptr || count < 0)
      m_words.fail("the number of elements, '" + printable(word) + "', " + (error != nullptr ? error : "is negative") +
                   "; correct the header");
    m_elements.push_back({name, static_cast<std::size_t>(count), {}});
    m_number_of_vertices += m_elements.back().is_vertex() ? m_elements.back().count : 0;
  }

  void read_property()
  {
    if(m_elements.empty())
      m_words.fail("there is a property before any element; correct the header");
    Property property = {};
    std::string_view word = m_words.next_word();
    if(word == "list") {
      property.type_of_size = &type(m_words.next_word());
      if(!property.type_of_size->is_integer)
        m_words.fail("the size of a list does not have an integer type; correct the header");
      word = m_words.next_word();
    }
    property.type = &type(word);
    property.name = m_words.next_word();
    m_elements.back().properties.push_back(property);
  }

  const Ply_type& type(std::string_view word) const
  {
    static const Ply_type types[] = {
        ply_type<std::int8_t>("char", "int8"),    ply_type<std::uint8_t>("uchar", "uint8"),
        ply_type<std::int16_t>("short", "int16"), ply_type<std::uint16_t>("ushort", "uint16"),
        ply_type<std::int32_t>("int", "int32"),   ply_type<std::uint32_t>("uint", "uint32"),
        ply_type<float>("float", "float32"),      ply_type<double>("double", "float64")};
    for(const Ply_type& type : types)
      if(word == type.name || word == type.other_name)
        return type;
    m_words.fail("'" + printable(word) + "' is not a number type of PLY files; correct the header");
  }

  double number(const Ply_type& type, const Element& element, bool is_coordinate = false)
  {
    if(m_bytes)
      return type.read(*m_bytes, element);
    const std::string_view word = m_words.next_word_of_text();
    const bool is_float = !type.is_integer && type.size == sizeof(float);
    const double value = type.is_integer ? static_cast<double>(m_words.number<long long>(word, element))
                         : is_float      ? static_cast<double>(m_words.number<float>(word, element))
                                         : m_words.number<double>(word, element);
    if(type.is_integer && (value < type.least || value > type.greatest))
      m_words.fail(element,
                   "has '" + printable(word) + "', which is outside the range of the property's type; correct it");
    if(is_coordinate && is_float && loses_digits(word, value) && ++m_rounded == 1)
      m_first_rounded = m_words.place() + ": '" + printable(word) + "'";
    return value;
  }

  // Returns whether a float differs from a number by more than half a unit of the number's last digit. Then the number
  // was not written from that float. A float keeps all numbers of `digits10` characters apart.
  static bool loses_digits(std::string_view word, double value)
  {
    double number = 0;
    return word.size() > std::numeric_limits<float>::digits10 && parse_number(word, number) == nullptr &&
           std::abs(number - value) > half_unit_of_last_digit(word);
  }

  std::size_t size_of_list(const Property& property, const Element& element)
  {
    const double size = number(*property.type_of_size, element);
    if(size < 0)
      scanner().fail(element, "has a list of negative size; correct it");
    return static_cast<std::size_t>(size);
  }

  void skip(const Property& property, const Element& element)
  {
    const std::size_t count = property.type_of_size != nullptr ? size_of_list(property, element) : 1;
    if(m_bytes)
      return m_bytes->skip(count * property.type->size, element);
    for(std::size_t i = 0; i < count; ++i)
      if(m_words.next_word_of_text().empty())
        m_words.fail(element, "is cut off; complete it");
  }

  void read_vertices(const Element_kind& kind)
  {
    const auto places = kind.coordinates();
    for(std::size_t i = 0; i < kind.count; ++i) {
      const Element element = {"vertex", m_soup.points.size()};
      std::array<double, 3> x = {0, 0, 0};
      for(std::size_t p = 0; p < kind.properties.size(); ++p) {
        const auto place = std::find(places.begin(), places.end(), p);
        if(place == places.end())
          skip(kind.properties[p], element);
        else
          x[static_cast<std::size_t>(place - places.begin())] =
              scanner().checked(number(*kind.properties[p].type, element, true), element);
      }
      m_soup.points.emplace_back(x[0], x[1], x[2]);
    }
  }

  void read_faces(const Element_kind& kind)
  {
    const std::size_t place = kind.corners();
    for(std::size_t i = 0; i < kind.count; ++i) {
      const Element element = {"face", m_soup.faces.size()};
      m_soup.faces.emplace_back();
      for(std::size_t p = 0; p < kind.properties.size(); ++p)
        if(p == place)
          read_face(kind.properties[p], element);
        else
          skip(kind.properties[p], element);
    }
  }

  void read_face(const Property& property, const Element& element)
  {
    for(std::size_t left = size_of_list(property, element); left > 0; --left) {
      const double v = number(*property.type, element);
      if(v < 0 || v >= static_cast<double>(m_number_of_vertices))
        scanner().fail(element, "has a vertex that is not one of the " + std::to_string(m_number_of_vertices) +
                                    " in the file; correct it");
      m_soup.faces.back().push_back(static_cast<std::size_t>(v));
    }
  }

  const Input_text& m_input;
  Text_scanner m_words;                // of the header, and of a text
  std::optional<Byte_scanner> m_bytes; // behind the header of a binary file
  std::vector<Element_kind> m_elements;
  std::size_t m_number_of_vertices = 0, m_rounded = 0;
  std::string m_first_rounded;
  Soup m_soup;
};

/// \throws Bad_input
inline Soup read_ply(const Input_text& input) { return Ply_reader(input).read(); }

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H
