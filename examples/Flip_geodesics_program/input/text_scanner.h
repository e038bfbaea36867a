// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_TEXT_SCANNER_H
#define CGAL_FLIP_GEODESICS_PROGRAM_TEXT_SCANNER_H

#include "decimal_numbers.h"
#include "input/input_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/*!
 * Goes through a text by lines and words and keeps the position for messages. Lines end with LF, CR LF or CR; words
 * stand between blanks and tabs. A byte order mark at the beginning is passed over.
 */
class Text_scanner
{
public:
  /// \param comment what starts a comment, up to the end of the line; nothing if it is 0
  /// \param has_continued_lines does a line with a backslash at its end go on in the next one?
  explicit Text_scanner(const Input_text& text, char comment = '\0', bool has_continued_lines = false)
    : m_input(&text)
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

  /// The place for messages: file and line.
  std::string place() const { return m_input->name() + " line " + std::to_string(m_line); }

  [[noreturn]] void fail(const std::string& what) const { throw Bad_input(place() + ": " + what); }
  [[noreturn]] void fail(const Element& element, const std::string& what) const
  {
    fail(element.kind + (' ' + std::to_string(element.index)) + ' ' + what);
  }

  /// The number that a word of an element is. \throws Bad_input
  template <class T>
  T number(std::string_view word, const Element& element) const
  {
    T value = 0;
    if(word.empty())
      fail(element, "is cut off; complete it");
    const char* const error = parse_number(word, value);
    if(error != nullptr && !(m_input->may_have_points_not_finite() && is_not_finite(value)))
      fail(element, "has '" + printable(word) + "', which " + error + "; correct it");
    return value;
  }

private:
  template <class T>
  static bool is_not_finite(T value)
  {
    if constexpr(std::is_floating_point<T>::value)
      return !std::isfinite(value);
    return false;
  }

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

  const Input_text* m_input;
  std::string_view m_text;
  char m_comment;
  bool m_has_continued_lines, m_is_continued = false;
  std::size_t m_at = 0, m_end = 0, m_next = 0; // in this line, its end, and the start of the next one
  std::size_t m_line = 0;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_TEXT_SCANNER_H
