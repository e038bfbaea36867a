// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE readers

#include "fuzz/reader_targets.h"
#include "output/json_text.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <clocale>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

// The readers of the program flip_geodesics and of the library, which fuzzing tries with any bytes: fuzz/ has the
// programs, and the inputs that were found or made up.

namespace {

using namespace program;

const std::filesystem::path corpus = FLIP_GEODESICS_CORPUS;

// The corners of all faces of a soup, as points, in an order that does not depend on that of the faces.
std::multiset<std::array<Soup::Point_3, 3>> triangles(const Soup& soup)
{
  std::multiset<std::array<Soup::Point_3, 3>> result;
  for(std::vector<std::size_t> face : soup.faces) {
    BOOST_REQUIRE_EQUAL(face.size(), 3);
    std::rotate(face.begin(),
                std::min_element(face.begin(), face.end(),
                                 [&](std::size_t v, std::size_t w) { return soup.points[v] < soup.points[w]; }),
                face.end());
    result.insert({soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]});
  }
  return result;
}

Soup tetrahedron(double scale)
{
  using Point = Soup::Point_3;
  return {{Point(0, 0, 0), Point(scale, 0, 0), Point(0, scale, 0), Point(0, 0, scale)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

std::string message(const std::string& file, const std::string& bytes)
{
  try {
    const Soup soup = read_soup({file, bytes});
    return "read: " + std::to_string(soup.points.size()) + " points, " + std::to_string(soup.faces.size()) + " faces";
  } catch(const Bad_input& error) {
    return error.what();
  }
}

void check_has(const std::string& text, const std::string& part)
{
  BOOST_CHECK_MESSAGE(text.find(part) != std::string::npos, "'" << part << "' is not in: " << text);
}

} // namespace

BOOST_AUTO_TEST_CASE(printable_text)
{
  BOOST_CHECK_EQUAL(printable("a b.off"), "a b.off");
  BOOST_CHECK_EQUAL(printable("Fl\xc3\xa4"
                              "che \xe9\x9d\xa2"),
                    "Fl\xc3\xa4"
                    "che \xe9\x9d\xa2"); // valid UTF-8 stays
  BOOST_CHECK_EQUAL(printable(std::string("\0\n\r\t\x1b[1m\x7f", 9)), "?????[1m?");
  BOOST_CHECK_EQUAL(printable("\xff\xc3\xc3\xa4\xc3"), "??\xc3\xa4?"); // no UTF-8, before UTF-8 and cut off
  BOOST_CHECK_EQUAL(printable("\xc0\xaf\xed\xa0\x80"), "?????");       // overlong, and half of a pair
  BOOST_CHECK_EQUAL(printable("\xc2\x9b"
                              "2J\xe2\x80\xae"
                              "a"),
                    "?2J?a"); // controls beyond ASCII
  const std::string cut = printable(std::string(1000, 'a') + std::string(1000, 'b'), 30);
  BOOST_CHECK_EQUAL(cut, std::string(20, 'a') + "..." + std::string(10, 'b'));
  std::string umlauts;
  for(int i = 0; i < 100; ++i)
    umlauts += "\xc3\xa4";
  for(std::size_t most = 1; most < 40; ++most)
    BOOST_CHECK(printable(umlauts, most).find('?') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_are_whole_words_in_range)
{
  double x = 0;
  for(const char* word : {"1", "+1", "1.", "1e0", "1E+0", "0.1e1", ".1e1"}) {
    BOOST_CHECK(parse_number<double>(word, x) == nullptr);
    BOOST_CHECK_EQUAL(x, 1);
  }
  BOOST_CHECK(parse_number<double>("1e-400", x) == nullptr);
  BOOST_CHECK_EQUAL(x, 0);
  BOOST_CHECK(parse_number<double>("-5e-324", x) == nullptr);
  BOOST_CHECK_EQUAL(x, -std::numeric_limits<double>::denorm_min());
  for(const char* word :
      {"", "+", "-", "+-1", "1x", "0x1", "1,5", "--1", "1e", "e1", "1e999", "-1e999", "nan", "inf", "-inf"})
    BOOST_CHECK_MESSAGE(parse_number<double>(word, x) != nullptr, word);
  float f = 0;
  BOOST_CHECK(parse_number<float>("1e39", f) != nullptr);
  long long i = 0;
  BOOST_CHECK(parse_number<long long>("-9223372036854775808", i) == nullptr);
  for(const char* word : {"9223372036854775808", "1.0", "1e3", "", "0x1"})
    BOOST_CHECK_MESSAGE(parse_number<long long>(word, i) != nullptr, word);
}

// Also in languages with a decimal comma, where one is installed.
BOOST_AUTO_TEST_CASE(numbers_of_json_have_a_point)
{
  for(const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
    BOOST_TEST_MESSAGE(locale << (std::setlocale(LC_NUMERIC, locale) != nullptr ? "" : " is not installed"));
    BOOST_TEST(json_number(0.1) == "0.10000000000000001");
    BOOST_TEST(json_number(-1.5) == "-1.5");
    BOOST_TEST(json_number(1e300) == "1.0000000000000001e+300");
    BOOST_TEST(json_number(5e-324) == "4.9406564584124654e-324");
    BOOST_TEST(json_number(std::numeric_limits<double>::infinity()) == "null");
  }
  std::setlocale(LC_NUMERIC, "C");
}

BOOST_AUTO_TEST_CASE(lines_words_and_places)
{
  const Input_text text = {"a.txt", "\xef\xbb\xbf"
                                    "a # x\r\n\r\n b\\\r c \n# \\\nd"};
  Text_scanner words(text, '#', true);
  BOOST_CHECK(words.next_line() && words.take('a') && !words.has_word());
  BOOST_CHECK(words.next_line_with_words());
  BOOST_CHECK_EQUAL(words.place(), "a.txt line 3");
  BOOST_CHECK_EQUAL(words.next_word(), "b");
  BOOST_CHECK_EQUAL(words.next_word(), "c");
  BOOST_CHECK_EQUAL(words.place(), "a.txt line 4");
  BOOST_CHECK_EQUAL(words.next_word(), "");
  BOOST_CHECK_EQUAL(words.next_word_of_text(), "d");
  BOOST_CHECK(!words.next_line());
}

// What the format allows is read, whatever one or another library makes of it.
BOOST_AUTO_TEST_CASE(all_spellings_of_a_tetrahedron)
{
  const auto expected = triangles(tetrahedron(1));
  for(const char* name : {"off/plain", "off/comments_crlf_mark", "off/words", "off/n_dimensions", "off/no_keyword",
                          "off/binary", "obj/plain", "obj/backward", "obj/faces_first", "obj/textured", "ply/text",
                          "ply/little_endian", "ply/big_endian", "stl/text", "stl/capitals", "stl/binary", "ts/plain"})
  {
    BOOST_TEST_CONTEXT(name)
    {
      const std::string format(name, std::string(name).find('/'));
      const Input_text input("a." + format, read_text((corpus / name).string()).bytes());
      const Soup soup = read_soup(input);
      BOOST_CHECK_EQUAL(soup.points.size(), 4);
      BOOST_CHECK(triangles(soup) == expected);
      BOOST_CHECK_EQUAL(read_mesh(input).mesh().number_of_faces(), 4);
    }
  }
  const Input_text input("A.OFF", read_text((corpus / "off/stcn4").string()).bytes());
  BOOST_CHECK(triangles(read_soup(input)) == triangles(tetrahedron(0.5))); // the fourth coordinate is 2
}

BOOST_AUTO_TEST_CASE(errors_name_line_and_element)
{
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  BOOST_CHECK_EQUAL(message("a.off", off + "3 0 1 2\n"), "read: 3 points, 1 faces");
  check_has(message("a.off", off), "a.off line 5: face 0 is missing");
  check_has(message("a.off", off + "3 0 1\n"), "a.off line 6: face 0 is cut off");
  check_has(message("a.off", off + "3 0 1 3\n"), "a.off line 6: face 0 has a vertex that is not one of the 3");
  check_has(message("a.off", off + "3 0 1 -1\n"), "a.off line 6: face 0 has a vertex that is not one of the 3");
  check_has(message("a.off", off + "3 0 1 18446744073709551615\n"),
            "face 0 has '18446744073709551615', which is out of range");
  check_has(message("a.off", off + "-3 0 1 2\n"), "face 0 has a negative number");
  check_has(message("a.off", off + "3 0 1 2 red\n"), "face 0 is followed by 'red'");
  check_has(message("a.off", off + "3 0 1 2\n3 0 2 1\n"), "line 7: there is text after the last face");
  check_has(message("a.off", "OFF\n1 0 0\n0 0\n"), "line 3: vertex 0 is cut off");
  check_has(message("a.off", "OFF\n1 0 0\n0 0 1e999\n"), "line 3: vertex 0 has '1e999', which is out of range");
  check_has(message("a.off", "OFF\n1 0 0\n0 0 inf\n"), "line 3: vertex 0 has 'inf', which is not a finite number");
  check_has(message("a.off", "4OFF\n1 0 0\n0 0 1 0\n"), "line 3: vertex 0 lies at infinity");
  check_has(message("a.off", "OFF\n-1 0 0\n"), "a.off line 2: the header announces");
  check_has(message("a.off", "OFF\n99999999999 0 0\n"), "a.off line 2: the header announces");
  check_has(message("a.off", "nOFF\n4 1 0 0\n0 0 0 0\n"), "three coordinates");
  // What a number too few makes of the file, read by words, is not taken.
  check_has(message("a.off", "OFF\n3 2 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"), "line 4: vertex 1 is cut off");
  check_has(message("a.off", "ply\n"), "the first word, 'ply', is not OFF");

  check_has(message("a.obj", "v 0 0 0\nf 1 1 2\n"), "a.obj line 2: face 0 has a vertex");
  check_has(message("a.obj", "v 0 0 0\nf 1 1 0\n"), "a.obj line 2: face 0 has a vertex");
  check_has(message("a.obj", "v 0 0 0\nv 0 1 x\n"), "a.obj line 2: vertex 1 has 'x'");
  check_has(message("a.obj", "v 0 0 0\nf 1 1 1.5\n"), "a.obj line 2: face 0 has '1.5'");
  check_has(message("a.obj", "v 0 0 1x\nf 1 1 1\n"), "a.obj line 1: vertex 0 has '1x'");
  BOOST_CHECK_EQUAL(message("a.obj", "v 0 0 1x\n"), "read: 1 points, 0 faces"); // a vertex of no face

  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  BOOST_CHECK_EQUAL(message("a.ply", ply + "end_header\n0 0 0\n"), "read: 1 points, 0 faces");
  check_has(message("a.ply", "ply\nformat ascii 1.0\nproperty float x\n"), "a.ply line 3: there is a property before");
  check_has(message("a.ply", ply + "end_header\n0 0 0 0\n"), "a.ply line 8: there is data");
  check_has(message("a.ply", ply + "end_header\n0 0\n"), "a.ply line 8: vertex 0 is cut off");
  check_has(message("a.ply", ply + "end_header\n0 0 1e39\n"),
            "a.ply line 8: vertex 0 has '1e39', which is out of range");
  check_has(message("a.ply", ply + "property list float int a\n"), "a.ply line 7: the size of a list");
  check_has(message("a.ply", ply), "a.ply line 6: the file ends before end_header");
  check_has(message("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\n"
                             "property double y\nproperty double z\nend_header\n"),
            "a.ply byte 118: vertex 0 is cut off");

  check_has(message("a.stl", "solid\nfacet\nvertex 0 0\nendfacet\n"), "a.stl line 4: face 0 has 'endfacet'");
  check_has(message("a.stl", "solid\nfacet\nvertex 0 0 0\nendfacet\n"), "a.stl line 4: face 0 has 1 vertex, but");
  check_has(message("a.stl", "solid\n"), "a.stl line 1: the file ends without endsolid");
  check_has(message("a.stl", "facet\n"), "too few for a binary STL file");
  check_has(message("a.ts", "VRTX 1 0 0 0\nTRGL 1 1 2\n"),
            "a.ts line 2: face 0 refers to a vertex that no earlier line defines");
  // A file of another kind.
  check_has(message("a.ts", "hello\nworld\n"), "a.ts: no line starts with GOCAD, VRTX or TRGL, so this is not a TS");
  check_has(message("a.ts", "END\n"), "this is not a TS file");
  check_has(message("a.ts", "GOCAD TSurf 1\n"), "a.ts line 1: the file ends without END");
  check_has(message("a.obj", "OFF\n3 1 0\n"),
            "a.obj: no line starts with `v` (a vertex) or `f` (a face), so this is not an OBJ");
  check_has(message("a\nb.xyz", ""), "a?b.xyz: the extension does not determine the format");
}

// Read by words, with colors of four components, these files have other vertices and no error.
BOOST_AUTO_TEST_CASE(colors_of_three_components)
{
  const std::string vertices = "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n0 0 1 9 9 9\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  BOOST_CHECK(triangles(read_soup({"a.off", "COFF\n4 4 0\n" + vertices + faces})) == triangles(tetrahedron(1)));
  check_has(message("a.off", "COFF\n4 4 0\n" + vertices + faces + "3 0 2 1\n"), "line 11: there is text after");
  check_has(message("a.off", "COFF\n4 4 0\n" + vertices + "3 0 0 0\n3 0 2\n" + faces), "line 8: face 1 is cut off");
  // Vertices without a color, which words would look for in the next ones.
  check_has(message("a.off", "COFF\n2 1 0\n0 0 0\n0 1 0\n1 1 0\n1 0 1 0 1 1 0\n"), "there is text after the last face");
}

// A text is read as a binary file with the same header is: as floats. If these cannot hold what is written, a line says
// so.
BOOST_AUTO_TEST_CASE(digits_beyond_a_float)
{
  const auto soup = [](const std::string& type, const std::string& coordinates) {
    return read_soup({"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty " + type + " x\nproperty " + type +
                                   " y\nproperty " + type + " z\nend_header\n" + coordinates + "\n"});
  };
  const Soup rounded = soup("float", "0.123456789012 1e-3 16777217");
  BOOST_CHECK_EQUAL(rounded.points.front().x(), static_cast<double>(0.123456789012f));
  BOOST_REQUIRE_EQUAL(rounded.remarks.size(), 1);
  check_has(rounded.remarks.front(), "a.ply line 8: '0.123456789012' has more digits than the type float");
  check_has(rounded.remarks.front(), "in total 2 coordinates were rounded; declare the type double");
  // As programs write floats, with all digits or fewer, or with fixed decimals.
  for(const char* written :
      {"0.1 0.123456791 -1.5", "1234.567871 0.000001 1e-30", "+1.17549435e-38 0.333333 8388607.5"})
    BOOST_CHECK_MESSAGE(soup("float", written).remarks.empty(), written);
  BOOST_CHECK(soup("double", "0.123456789012 1e-3 16777217").remarks.empty());
  BOOST_CHECK_EQUAL(half_unit_of_last_digit("-1.25"), 0.005);
  BOOST_CHECK_EQUAL(half_unit_of_last_digit("12e+1"), 5);
}

BOOST_AUTO_TEST_CASE(curve_files)
{
  const Input_mesh& mesh = reader_targets::octahedron();
  const auto pairs = [&](const std::string& bytes) {
    try {
      return "read: " + std::to_string(read_pairs(mesh, {"a.txt", bytes}).size());
    } catch(const Bad_input& error) {
      return std::string(error.what());
    }
  };
  BOOST_CHECK_EQUAL(pairs("\xef\xbb\xbf"
                          "0 5\r\n1\t3 # c\r\r2 4"),
                    "read: 3");
  check_has(pairs("0 1\n0 99999999999999999999\n"),
            "a.txt line 2: '99999999999999999999' is not the number of a vertex; write a whole number");
  BOOST_CHECK_EQUAL(pairs("0,5\n1, 3\n0.5,0,0 0\n0.5,0,0,0,0.5,1\n"), "read: 4");
  check_has(pairs("0,1,2\n"), "a pair consists of two points, not 1");
  check_has(pairs("0 6\n"), "a.txt line 1: vertex 6 does not exist; use 0 to 5");
  check_has(pairs("0 \x1b[31m\n"), "'?[31m' is not a point");
  BOOST_CHECK_LT(pairs("0 " + std::string(100000, '9') + "\n").size(), 300);
}

BOOST_AUTO_TEST_CASE(replayed_inputs)
{
  std::size_t folders = 0;
  for(const auto& folder : std::filesystem::directory_iterator(corpus)) {
    const reader_targets::Target target = reader_targets::all().at(folder.path().filename().string());
    std::size_t inputs = 0;
    for(const auto& file : std::filesystem::directory_iterator(folder)) {
      BOOST_TEST_INFO(file.path());
      BOOST_CHECK_NO_THROW(target(read_text(file.path().string()).bytes()));
      ++inputs;
    }
    BOOST_CHECK_GE(inputs, 5);
    ++folders;
  }
  BOOST_CHECK_EQUAL(folders, reader_targets::all().size());
}
