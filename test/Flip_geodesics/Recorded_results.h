// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_RECORDED_RESULTS_H
#define FLIP_GEODESICS_TEST_RECORDED_RESULTS_H

#include "Integer_hash.h"
#include "test_scale.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/// Many positive numbers in one, with other weights for each, so that their order counts. What is not finite counts 1.
class Weighted_sum
{
public:
  void add(double value)
  {
    m_weight = std::fmod(m_weight + 0.6180339887498949, 1.0);
    m_sum += (1 + m_weight) * (std::isfinite(value) ? value : 1);
  }

  double value() const { return m_sum; }

private:
  double m_sum = 0, m_weight = 0;
};

/// What a function has given for one input: named values, integers and hashes to be met exactly, others nearly.
class Result
{
public:
  void add(const std::string& name, const std::string& value) { m_values.emplace_back(name, value); }
  void add(const std::string& name, const Integer_hash& hash) { add(name, hash.text()); }
  void add(const std::string& name, const Weighted_sum& sum) { add(name, sum.value()); }

  template <class Integer>
  void count(const std::string& name, Integer value)
  {
    add(name, std::to_string(static_cast<long long>(value)));
  }

  void add(const std::string& name, double value)
  {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.13e", value);
    add(name, digits);
  }

  void append(const Result& other) { m_values.insert(m_values.end(), other.m_values.begin(), other.m_values.end()); }

  std::string text() const
  {
    std::string result;
    for(const auto& [name, value] : m_values)
      result += (result.empty() ? "" : " ") + name + " " + value;
    return result;
  }

private:
  std::vector<std::pair<std::string, std::string>> m_values;
};

/// The last bits of functions that the standard does not fix, and of a product and a sum that may be one operation.
inline std::string fingerprint_of_arithmetic()
{
  Integer_hash hash;
  const auto add = [&hash](double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    hash.add(static_cast<long long>(std::ldexp(fraction, 53)));
    hash.add(exponent);
  };
  double x = 0.3, y = 0.7;
  for(int i = 0; i < 5000; ++i) {
    x = std::fmod(x + 0.6180339887498949, 1.0);
    y = std::fmod(y + 0.4142135623730951, 1.0);
    for(double value : {std::hypot(x, y), std::atan2(x, y), std::sin(4 * x), std::cos(4 * x), std::asin(x), x * y + x})
      add(value);
  }
  return hash.text();
}

/// What results depend on: doubles as IEEE 754 has them, or the last bits of all that is made of them.
enum class Depends_on { INPUT, ARITHMETIC };

/*
 * What one function gave for its inputs once, in a file of lines `function input: name value name value ...`. With the
 * environment variable FLIP_GEODESICS_RECORD the file's lines for the function are replaced.
 *
 * Where paths of the same length, or rays along a line, are told from each other by rounding, other last bits of
 * std::hypot() or std::atan2() give other results, as right as these. They are compared only where the bits are those
 * of the machine that recorded.
 */
class Recorded_results
{
public:
  Recorded_results(const std::string& file, const std::string& function, Depends_on depends_on)
    : m_file(file)
    , m_function(function)
    , m_depends_on(depends_on)
    , m_is_recording(std::getenv("FLIP_GEODESICS_RECORD") != nullptr)
  {
    std::ifstream in(file);
    for(std::string line; std::getline(in, line);)
      if(const std::size_t colon = line.find(": "); colon != std::string::npos)
        m_lines[line.substr(0, colon)] = line.substr(colon + 2);
  }

  void compare(const std::string& input, const Result& result) { m_results[m_function + " " + input] = result.text(); }

  /// Compares what there is, or writes it; no recorded line may lack, unless inputs are left out on purpose.
  void finish()
  {
    if(m_is_recording) {
      BOOST_TEST_REQUIRE(stride == 1, "results are recorded by a build that looks at all inputs");
      return record();
    }
    if(m_depends_on == Depends_on::ARITHMETIC && m_lines["arithmetic"] != fingerprint_of_arithmetic()) {
      BOOST_TEST_MESSAGE(m_function << " is not compared: the last bits of elementary functions are others here");
      return;
    }
    for(const auto& [key, text] : m_results) {
      const auto line = m_lines.find(key);
      BOOST_TEST((line != m_lines.end() && is_same(line->second, text)),
                 key << "\n  recorded: " << (line == m_lines.end() ? "nothing" : line->second)
                     << "\n  now:      " << text);
    }
    BOOST_TEST(!m_results.empty());
    if(stride > 1) // some of the inputs are left out
      return;
    for(const auto& [key, text] : m_lines)
      BOOST_TEST((!is_ours(key) || m_results.count(key) != 0), key << " is recorded, but not met");
  }

private:
  bool is_ours(const std::string& key) const { return key.compare(0, m_function.size() + 1, m_function + " ") == 0; }

  void record()
  {
    for(auto line = m_lines.begin(); line != m_lines.end();)
      line = is_ours(line->first) ? m_lines.erase(line) : std::next(line);
    m_lines.insert(m_results.begin(), m_results.end());
    m_lines["arithmetic"] = fingerprint_of_arithmetic();
    std::ofstream out(m_file);
    for(const auto& [key, text] : m_lines)
      out << key << ": " << text << "\n";
    BOOST_TEST(out.good());
  }

  static bool is_same(const std::string& a, const std::string& b)
  {
    std::istringstream in_a(a), in_b(b);
    std::string x, y;
    while(in_a >> x) {
      if(!(in_b >> y) || !is_same_word(x, y))
        return false;
    }
    return !(in_b >> y);
  }

  // Numbers with a point are told to 14 digits, of which nine count.
  static bool is_same_word(const std::string& x, const std::string& y)
  {
    if(x == y)
      return true;
    if(x.find('.') == std::string::npos || y.find('.') == std::string::npos)
      return false;
    const double a = std::strtod(x.c_str(), nullptr), b = std::strtod(y.c_str(), nullptr);
    return std::abs(a - b) <= 1e-9 * std::abs(a);
  }

  std::string m_file, m_function;
  Depends_on m_depends_on;
  bool m_is_recording;
  std::map<std::string, std::string> m_lines, m_results;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_RECORDED_RESULTS_H
