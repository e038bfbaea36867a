// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_DECIMAL_NUMBERS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_DECIMAL_NUMBERS_H

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>
#include <version>

// Numbers as text, whatever the locale. Some standard libraries do not have that for floating point numbers: those are
// used where the locale is that of C.
namespace program {

#if defined(__cpp_lib_to_chars)

using std::from_chars;

/// A number with all digits.
inline std::string decimal_text(double x)
{
  char text[32];
  constexpr int digits = std::numeric_limits<double>::max_digits10;
  return std::string(text, std::to_chars(text, text + sizeof text, x, std::chars_format::general, digits).ptr);
}

#else

/// As the standard has it: no blanks, no plus sign, no hexadecimal numbers.
template <class Float>
std::from_chars_result float_from_chars(const char* first, const char* last, Float& value)
{
  std::string text(first, last);
  const std::size_t sign = text.substr(0, 1) == "-" ? 1 : 0;
  if(text.size() == sign || std::string(" \t\n\v\f\r+-").find(text[sign]) != std::string::npos)
    return {first, std::errc::invalid_argument};
  if(const std::size_t x = text.find_first_of("xX"); x != std::string::npos)
    text.resize(x); // of a hexadecimal number the zero is taken
  errno = 0;
  char* end = nullptr;
  const Float x = std::is_same<Float, float>::value ? std::strtof(text.c_str(), &end)
                                                    : static_cast<Float>(std::strtod(text.c_str(), &end));
  const std::ptrdiff_t length = end - text.c_str();
  if(length == 0)
    return {first, std::errc::invalid_argument};
  if(errno == ERANGE)
    return {first + length, std::errc::result_out_of_range};
  value = x;
  return {first + length, std::errc()};
}

template <class Number>
std::from_chars_result from_chars(const char* first, const char* last, Number& value)
{
  if constexpr(std::is_floating_point<Number>::value)
    return float_from_chars(first, last, value);
  else
    return std::from_chars(first, last, value);
}

/// A number with all digits.
inline std::string decimal_text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<double>::max_digits10, x);
  return text;
}

#endif

/// Numbers next to zero are taken as what they round to; libraries differ in whether from_chars() does that.
template <class T>
bool rounds_to_zero(std::string_view word, T& value)
{
  std::istringstream in{std::string(word)};
  in.imbue(std::locale::classic());
  return static_cast<bool>(in >> value) && std::abs(value) < 1;
}

/// Reads a decimal number that is the whole word. \return what is wrong with the word, or null
template <class T>
const char* parse_number(std::string_view word, T& value)
{
  std::string_view digits = word;
  if(digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.remove_prefix(1);
  const auto [end, error] = from_chars(digits.data(), digits.data() + digits.size(), value);
  if(error == std::errc::invalid_argument || end != digits.data() + digits.size())
    return std::is_integral<T>::value ? "is not a whole number" : "is not a number";
  if constexpr(std::is_floating_point<T>::value) {
    if(error == std::errc::result_out_of_range && !rounds_to_zero(digits, value))
      return "is out of range";
    return std::isfinite(value) ? nullptr : "is not a finite number";
  }
  return error == std::errc::result_out_of_range ? "is out of range" : nullptr;
}

/// The pieces of a text between its commas.
inline std::vector<std::string_view> pieces_of(std::string_view text)
{
  std::vector<std::string_view> pieces;
  for(std::size_t comma; (comma = text.find(',')) != std::string_view::npos; text.remove_prefix(comma + 1))
    pieces.push_back(text.substr(0, comma));
  pieces.push_back(text);
  return pieces;
}

/// Half a unit of the last digit of a decimal number, as 0.005 for 1.25.
inline double half_unit_of_last_digit(std::string_view number)
{
  const std::size_t mark = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, mark);
  const std::size_t point = digits.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : digits.size() - point - 1;
  double exponent = 0;
  if(mark != std::string_view::npos)
    parse_number(number.substr(mark + 1), exponent);
  return 0.5 * std::pow(10., exponent - static_cast<double>(decimals));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_DECIMAL_NUMBERS_H
