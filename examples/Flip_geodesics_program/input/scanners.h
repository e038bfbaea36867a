// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SCANNERS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SCANNERS_H

#include "decimal_numbers.h"
#include "input/input_text.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace program {

/// An element of a mesh or a line, for messages: "vertex 7".
struct Element
{
  const char* kind;
  std::size_t index;
};

/// The errors of what goes through a file, each with its place.
class Scanner
{
public:
  explicit Scanner(const Input_text& input)
    : m_input(&input)
  {
  }

  /// Returns the place for messages: the file, and the position in it.
  virtual std::string place() const = 0;

  [[noreturn]] void fail(const std::string& what) const { throw Bad_input(place() + ": " + what); }
  [[noreturn]] void fail(const Element& element, const std::string& what) const
  {
    throw Bad_input(message(element, what));
  }
  std::string message(const Element& element, const std::string& what) const
  {
    return place() + ": " + element.kind + ' ' + std::to_string(element.index) + ' ' + what;
  }

  /// Returns a coordinate. \throws Bad_input if it is not finite, and has to be
  double checked(double coordinate, const Element& element) const
  {
    if(!std::isfinite(coordinate) && !m_input->may_have_points_not_finite())
      fail(element, "has a coordinate that is not a finite number; correct it");
    return coordinate;
  }

protected:
  const Input_text& input() const { return *m_input; }

private:
  const Input_text* m_input;
};

/*!
 * Goes through a text by lines and words and keeps the position for messages. Lines end with LF, CR LF or CR; words
 * stand between blanks and tabs. A byte order mark at the beginning is passed over.
 */
class Text_scanner final : public Scanner
{
public:
  /// \param comment what starts a comment, up to the end of the line; nothing if it is 0
  /// \param has_continued_lines does a line with a backslash at its end go on in the next one?
  explicit Text_scanner(const Input_text& text, char comment = '\0', bool has_continued_lines = false)
    : Scanner(text)
    , m_text(text.bytes())
    , m_comment(comment)
    , m_has_continued_lines(has_continued_lines)
  {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if(m_text.substr(0, mark.size()) == mark)
      m_next = mark.size();
  }

  /// Goes to the next line. \return false at the end of the text
  bool next_line()
  {
    while(m_is_continued && find_line()) {
    }
    return find_line();
  }

  /// Goes to the next line that has a word.
  bool next_line_with_words()
  {
    while(next_line())
      if(has_word())
        return true;
    return false;
  }

  /// Is there another word on this line?
  bool has_word()
  {
    while(true) {
      while(m_at < m_end && is_blank(m_text[m_at]))
        ++m_at;
      if(m_at < m_end)
        return true;
      if(!m_is_continued || !find_line())
        return false;
    }
  }

  /// The next word of the line; empty at its end.
  std::string_view next_word()
  {
    if(!has_word())
      return {};
    const std::size_t start = m_at;
    while(m_at < m_end && !is_blank(m_text[m_at]))
      ++m_at;
    return m_text.substr(start, m_at - start);
  }

  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view next_word_of_text()
  {
    while(!has_word())
      if(!next_line())
        return {};
    return next_word();
  }

  /// Goes back in the line, by as many bytes.
  void go_back(std::size_t bytes) { m_at -= bytes; }

  /// Passes over a mark in front of the next word, blanks behind it or not. \return is it there?
  bool take(char mark)
  {
    if(!has_word() || m_text[m_at] != mark)
      return false;
    ++m_at;
    return true;
  }

  /// What is left of the line.
  std::string_view rest_of_line() const { return m_text.substr(m_at, m_end - m_at); }
  void skip_line() { m_at = m_end; }

  /// The start of the next line.
  std::size_t next_position() const { return m_next; }

  /// Returns the file and the line.
  std::string place() const override { return input().name() + " line " + std::to_string(m_line); }

  /// The number that a word of an element is. \throws Bad_input
  template <class T>
  T number(std::string_view word, const Element& element) const
  {
    T value = 0;
    if(word.empty())
      fail(element, "is cut off; complete it");
    const char* const error = parse_number(word, value);
    const bool is_not_finite = std::is_floating_point<T>::value && !std::isfinite(static_cast<double>(value));
    if(error != nullptr && !(is_not_finite && input().may_have_points_not_finite()))
      fail(element, "has '" + printable(word) + "', which " + error + "; correct it");
    return value;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  bool find_line()
  {
    m_is_continued = false;
    m_at = m_end = m_next;
    if(m_next >= m_text.size())
      return false;
    ++m_line;
    m_end = (std::min)(m_text.find_first_of("\r\n", m_at), m_text.size());
    m_next = m_text.substr(m_end, 2) == "\r\n" ? m_end + 2 : (std::min)(m_end + 1, m_text.size());
    if(m_comment != '\0')
      m_end = m_at + (std::min)(m_text.substr(m_at, m_end - m_at).find(m_comment), m_end - m_at);
    if(m_has_continued_lines)
      take_backslash();
    return true;
  }

  void take_backslash()
  {
    std::size_t end = m_end;
    while(end > m_at && is_blank(m_text[end - 1]))
      --end;
    m_is_continued = end > m_at && m_text[end - 1] == '\\';
    if(m_is_continued)
      m_end = end - 1;
  }

  std::string_view m_text;
  char m_comment;
  bool m_has_continued_lines, m_is_continued = false;
  std::size_t m_at = 0, m_end = 0, m_next = 0; // in this line, its end, and the start of the next one
  std::size_t m_line = 0;
};

/// Goes through the binary part of a file and keeps the position for messages.
class Byte_scanner final : public Scanner
{
public:
  Byte_scanner(const Input_text& input, std::size_t position, boost::endian::order order)
    : Scanner(input)
    , m_at(position)
    , m_order(order)
  {
  }

  bool is_at_end() const { return bytes_left() == 0; }
  std::size_t bytes_left() const { return input().bytes().size() - m_at; }

  /// Returns the file and the byte.
  std::string place() const override { return input().name() + " byte " + std::to_string(m_at); }

  void skip(std::size_t bytes, const Element& element)
  {
    if(bytes > bytes_left())
      fail(element, "is cut off; complete it");
    m_at += bytes;
  }

  /// The next number of an element. \throws Bad_input
  template <class T>
  T get(const Element& element)
  {
    const std::size_t start = m_at;
    skip(sizeof(T), element);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &input().bytes()[start], sizeof bytes);
    if(m_order != boost::endian::order::native)
      std::reverse(bytes, bytes + sizeof bytes);
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

private:
  std::size_t m_at;
  boost::endian::order m_order;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SCANNERS_H
