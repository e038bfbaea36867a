// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H

#include "input/byte_scanner.h"
#include "input/soup.h"
#include "input/text_scanner.h"
#include "readable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// What a PLY file promises in its header.
struct Ply_header
{
  enum class Type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };
  enum class Format { TEXT, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

  struct Property
  {
    std::string name;
    Type type;
    std::optional<Type> type_of_count; ///< of a list
  };

  struct Element_kind
  {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;

    /// The position of a property among others; their number if there is none of that name.
    std::size_t find(std::string_view property) const
    {
      const auto found =
          std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == property; });
      return static_cast<std::size_t>(found - properties.begin());
    }
  };

  Format format = Format::TEXT;
  std::vector<Element_kind> elements;

  /// Calls `use` with a number of a type, which is 0.
  template <class Function>
  static void for_type(Type type, const Function& use)
  {
    switch(type) {
    case Type::INT8:
      return use(std::int8_t());
    case Type::UINT8:
      return use(std::uint8_t());
    case Type::INT16:
      return use(std::int16_t());
    case Type::UINT16:
      return use(std::uint16_t());
    case Type::INT32:
      return use(std::int32_t());
    case Type::UINT32:
      return use(std::uint32_t());
    case Type::FLOAT:
      return use(float());
    case Type::DOUBLE:
      return use(double());
    }
  }

  static std::size_t size(Type type)
  {
    std::size_t result = 0;
    for_type(type, [&](auto number) { result = sizeof number; });
    return result;
  }

  static bool is_integer(Type type) { return type != Type::FLOAT && type != Type::DOUBLE; }
};

/// Reads the lines of a PLY file from `ply` to `end_header`.
class Ply_header_reader
{
public:
  explicit Ply_header_reader(Text_scanner& lines)
    : m_lines(lines)
  {
  }

  /// \throws Bad_input
  Ply_header read()
  {
    if(!m_lines.next_line() || m_lines.next_word() != "ply")
      m_lines.fail("the first word is not ply, so this is not a PLY file; correct the file or its extension");
    read_format();
    while(true) {
      const std::string_view keyword = next_keyword();
      if(keyword == "end_header")
        return m_header;
      if(keyword == "element")
        read_element();
      else if(keyword == "property")
        read_property();
      // What else there may be, programs write as comments without a keyword.
    }
  }

private:
  // The first word of the next line that is not a comment.
  std::string_view next_keyword()
  {
    while(m_lines.next_line_with_words()) {
      const std::string_view keyword = m_lines.next_word();
      if(keyword != "comment" && keyword != "obj_info")
        return keyword;
    }
    m_lines.fail("the file ends before end_header; complete it");
  }

  void read_format()
  {
    const std::string_view keyword = next_keyword(), format = m_lines.next_word();
    if(keyword != "format" || m_lines.next_word() != "1.0")
      m_lines.fail("the format is missing, or its version is not 1.0; correct the header");
    if(format == "binary_little_endian")
      m_header.format = Ply_header::Format::LITTLE_ENDIAN_BYTES;
    else if(format == "binary_big_endian")
      m_header.format = Ply_header::Format::BIG_ENDIAN_BYTES;
    else if(format != "ascii")
      m_lines.fail("the format '" + printable(format) +
                   "' is not known; use ascii, binary_little_endian or "
                   "binary_big_endian");
  }

  void read_element()
  {
    const std::string name(m_lines.next_word());
    const std::string_view word = m_lines.next_word();
    long long count = 0;
    const char* const error = parse_number(word, count);
    if(error != nullptr || count < 0)
      m_lines.fail("the number of elements, '" + printable(word) + "', " + (error != nullptr ? error : "is negative") +
                   "; correct the header");
    m_header.elements.push_back({name, static_cast<std::size_t>(count), {}});
  }

  void read_property()
  {
    if(m_header.elements.empty())
      m_lines.fail("there is a property before any element; correct the header");
    std::optional<Ply_header::Type> type_of_count;
    std::string_view word = m_lines.next_word();
    if(word == "list") {
      type_of_count = type(m_lines.next_word());
      if(!Ply_header::is_integer(*type_of_count))
        m_lines.fail("the size of a list does not have an integer type; correct the header");
      word = m_lines.next_word();
    }
    const Ply_header::Type type_of_number = type(word);
    m_header.elements.back().properties.push_back({std::string(m_lines.next_word()), type_of_number, type_of_count});
  }

  Ply_header::Type type(std::string_view word) const
  {
    using Type = Ply_header::Type;
    static const std::pair<std::string_view, Type> names[] = {
        {"char", Type::INT8},   {"int8", Type::INT8},     {"uchar", Type::UINT8},   {"uint8", Type::UINT8},
        {"short", Type::INT16}, {"int16", Type::INT16},   {"ushort", Type::UINT16}, {"uint16", Type::UINT16},
        {"int", Type::INT32},   {"int32", Type::INT32},   {"uint", Type::UINT32},   {"uint32", Type::UINT32},
        {"float", Type::FLOAT}, {"float32", Type::FLOAT}, {"double", Type::DOUBLE}, {"float64", Type::DOUBLE}};
    for(const auto& [name, type] : names)
      if(word == name)
        return type;
    m_lines.fail("'" + printable(word) + "' is not a number type of PLY files; correct the header");
  }

  Text_scanner& m_lines;
  Ply_header m_header;
};

/// The numbers behind the header, in words.
class Ply_words
{
public:
  explicit Ply_words(const Text_scanner& words)
    : m_words(words)
  {
  }

  template <class T>
  T get(const Element& element)
  {
    return number<T>(m_words.next_word_of_text(), element);
  }

  template <class T>
  double coordinate(const Element& element)
  {
    const std::string_view word = m_words.next_word_of_text();
    const T value = number<T>(word, element);
    if(std::is_same<T, float>::value && loses_digits(word, static_cast<double>(value)) && ++m_rounded == 1)
      m_first_rounded = m_words.place() + ": '" + printable(word) + "'";
    return static_cast<double>(value);
  }

  /// A line about the coordinates that have more digits than their type; empty if there are none.
  std::string remark() const
  {
    if(m_rounded == 0)
      return {};
    return m_first_rounded +
           " has more digits than the type float of the header can store, and was rounded; in total " +
           counted(m_rounded, "coordinate was", "coordinates were") +
           " rounded; declare the type double to keep all digits";
  }

  void skip(std::size_t words, const Element& element)
  {
    for(std::size_t i = 0; i < words; ++i)
      if(m_words.next_word_of_text().empty())
        fail(element, "is cut off; complete it");
  }

  [[noreturn]] void fail(const std::string& what) const { m_words.fail(what); }
  [[noreturn]] void fail(const Element& element, const std::string& what) const { m_words.fail(element, what); }

  bool is_at_end() { return m_words.next_word_of_text().empty(); }

private:
  template <class T>
  T number(std::string_view word, const Element& element) const
  {
    using Parsed = std::conditional_t<std::is_integral<T>::value, long long, T>;
    const Parsed value = m_words.number<Parsed>(word, element);
    if(std::is_integral<T>::value && (value < static_cast<Parsed>((std::numeric_limits<T>::lowest)()) ||
                                      value > static_cast<Parsed>((std::numeric_limits<T>::max)())))
      m_words.fail(element, "has '" + printable(word) + "', which exceeds the range of its type; correct it");
    return static_cast<T>(value);
  }

  // Returns whether a float differs from a number by more than half a unit of the number's last digit. Then the number
  // was not written from that float. A float keeps all numbers of `digits10` characters apart.
  static bool loses_digits(std::string_view word, double value)
  {
    double number = 0;
    return word.size() > std::numeric_limits<float>::digits10 && parse_number(word, number) == nullptr &&
           std::abs(number - value) > half_unit_of_last_digit(word);
  }

  Text_scanner m_words;
  std::size_t m_rounded = 0;
  std::string m_first_rounded;
};

inline std::string remark_on(const Ply_words& words) { return words.remark(); }
inline std::string remark_on(const Byte_scanner&) { return {}; }

inline void skip_numbers(Ply_words& words, Ply_header::Type, std::size_t count, const Element& element)
{
  words.skip(count, element);
}

inline void skip_numbers(Byte_scanner& bytes, Ply_header::Type type, std::size_t count, const Element& element)
{
  bytes.skip(count * Ply_header::size(type), element);
}

/// Reads what is behind the header. `Source` is `Ply_words` or `Byte_scanner`.
template <class Source>
class Ply_body_reader
{
  using Type = Ply_header::Type;
  using Property = Ply_header::Property;
  using Element_kind = Ply_header::Element_kind;

public:
  Ply_body_reader(const Ply_header& header, Source& source)
    : m_header(header)
    , m_source(source)
  {
    for(const Element_kind& kind : header.elements)
      if(is_vertex(kind))
        m_number_of_vertices += kind.count;
  }

  /// \throws Bad_input
  Soup read()
  {
    for(const Element_kind& kind : m_header.elements) {
      if(is_vertex(kind))
        read_vertices(kind);
      else if(kind.name == "face" || kind.name == "faces")
        read_faces(kind);
      else if(kind.name == "tristrips")
        m_source.fail("the file has triangle strips, which are not read; write faces");
      else if(!kind.properties.empty())
        skip_elements(kind);
    }
    if(!m_source.is_at_end())
      m_source.fail("there is data after the last element; remove it, or correct the header");
    if(const std::string remark = remark_on(m_source); !remark.empty())
      m_soup.remarks.push_back(remark);
    return std::move(m_soup);
  }

private:
  static bool is_vertex(const Element_kind& kind) { return kind.name == "vertex" || kind.name == "vertices"; }

  void read_vertices(const Element_kind& kind)
  {
    const std::array<std::size_t, 3> places = {kind.find("x"), kind.find("y"), kind.find("z")};
    for(std::size_t place : places)
      if(place == kind.properties.size() || kind.properties[place].type_of_count)
        m_source.fail("the vertices do not have the properties x, y and z; correct the header");
    for(std::size_t i = 0; i < kind.count; ++i) {
      const Element element = {"vertex", m_soup.points.size()};
      std::array<double, 3> x = {0, 0, 0};
      for(std::size_t p = 0; p < kind.properties.size(); ++p) {
        const auto place = std::find(places.begin(), places.end(), p);
        if(place == places.end())
          skip(kind.properties[p], element);
        else
          x[static_cast<std::size_t>(place - places.begin())] = read_coordinate(kind.properties[p].type, element);
      }
      m_soup.points.emplace_back(x[0], x[1], x[2]);
    }
  }

  void read_faces(const Element_kind& kind)
  {
    const std::size_t place = (std::min)(kind.find("vertex_indices"), kind.find("vertex_index"));
    if(place == kind.properties.size() || !kind.properties[place].type_of_count ||
       !Ply_header::is_integer(kind.properties[place].type))
      m_source.fail("the faces do not have a list of integers vertex_indices; correct the header");
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
    const std::size_t size = read_size(property, element);
    for(std::size_t i = 0; i < size; ++i) {
      const long long v = read_integer(property.type, element);
      if(v < 0 || static_cast<unsigned long long>(v) >= m_number_of_vertices)
        m_source.fail(element, "has a vertex that is not one of the " + std::to_string(m_number_of_vertices) +
                                   " in the file; correct it");
      m_soup.faces.back().push_back(static_cast<std::size_t>(v));
    }
  }

  void skip_elements(const Element_kind& kind)
  {
    for(std::size_t i = 0; i < kind.count; ++i)
      for(const Property& property : kind.properties)
        skip(property, {"other element", i});
  }

  void skip(const Property& property, const Element& element)
  {
    skip_numbers(m_source, property.type, property.type_of_count ? read_size(property, element) : 1, element);
  }

  std::size_t read_size(const Property& property, const Element& element)
  {
    const long long size = read_integer(*property.type_of_count, element);
    if(size < 0)
      m_source.fail(element, "has a list of negative size; correct it");
    return static_cast<std::size_t>(size);
  }

  long long read_integer(Type type, const Element& element)
  {
    long long result = 0;
    Ply_header::for_type(
        type, [&](auto number) { result = static_cast<long long>(m_source.template get<decltype(number)>(element)); });
    return result;
  }

  double read_coordinate(Type type, const Element& element)
  {
    double result = 0;
    Ply_header::for_type(type, [&](auto number) { result = m_source.template coordinate<decltype(number)>(element); });
    return result;
  }

  const Ply_header& m_header;
  Source& m_source;
  Soup m_soup;
  std::size_t m_number_of_vertices = 0;
};

/*!
 * Reads a PLY file, a text or binary: `x`, `y`, `z` of its vertices and the list `vertex_indices`, or `vertex_index`,
 * of its faces, of any types. All else is passed over. Coordinates are rounded to their type, in a text as in a binary
 * file; a remark is printed if digits are lost.
 *
 * \throws Bad_input
 */
inline Soup read_ply(const Input_text& input)
{
  using boost::endian::order;
  Text_scanner lines(input);
  const Ply_header header = Ply_header_reader(lines).read();
  if(header.format == Ply_header::Format::TEXT) {
    Ply_words words(lines);
    return Ply_body_reader<Ply_words>(header, words).read();
  }
  std::size_t start = lines.next_position();
  const std::size_t first_end = input.bytes().find_first_of("\r\n");
  if(input.bytes().substr(first_end, 1) == "\r" && input.bytes().substr(first_end, 2) != "\r\n")
    start = input.bytes().rfind('\r', start - 1) + 1; // lines end with CR alone: an LF behind it is a number's
  Byte_scanner bytes(input, start, header.format == Ply_header::Format::BIG_ENDIAN_BYTES ? order::big : order::little);
  return Ply_body_reader<Byte_scanner>(header, bytes).read();
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READ_PLY_H
