// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_WRITTEN_FILES_H
#define FLIP_GEODESICS_TEST_WRITTEN_FILES_H

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// Readers of the files that the writers write, which share nothing with them; they check all that a format asks for.

namespace Flip_geodesics_test {

/// What is in a file.
struct Written
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<long, 3>> triangles;
  std::vector<long> triangle_curves;       ///< the curve of each triangle, -1 for a surface
  std::map<long, std::vector<long>> lines; ///< by the number of the curve
  std::vector<long> loose_points;
  bool has_loose_points = true;                      ///< does the format tell them?
  std::map<std::string, std::vector<double>> values; ///< at the points, by name; vectors one after the other
};

namespace internal {

// The lowest byte first, on any machine.
template <class Number>
Number number_at(const std::string& bytes, std::size_t at)
{
  BOOST_REQUIRE_LE(at + sizeof(Number), bytes.size());
  std::uint64_t value = 0;
  for(std::size_t i = sizeof(Number); i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  using Half = std::conditional_t<sizeof(Number) == 1, std::uint8_t, std::uint32_t>;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, Half>;
  const Bits bits = static_cast<Bits>(value);
  Number result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

// Numbers of a text or of bytes, one after the other. No stream reads all doubles: some fail for denormal ones.
class Numbers
{
public:
  Numbers(const std::string& data, std::size_t at, bool is_binary)
    : m_data(data)
    , m_at(at)
    , m_is_binary(is_binary)
  {
  }

  template <class Number>
  Number next()
  {
    if(m_is_binary) {
      m_at += sizeof(Number);
      return number_at<Number>(m_data, m_at - sizeof(Number));
    }
    const std::size_t start = m_data.find_first_not_of(" \n", m_at);
    BOOST_REQUIRE_NE(start, std::string::npos);
    m_at = (std::min)(m_data.find_first_of(" \n", start), m_data.size());
    const std::string word = m_data.substr(start, m_at - start);
    const double value = std::strtod(word.c_str(), nullptr);
    BOOST_CHECK_EQUAL(word.find_first_not_of("0123456789.e+-"), std::string::npos);
    return static_cast<Number>(value);
  }

  std::array<double, 3> point()
  {
    std::array<double, 3> result;
    for(double& x : result)
      x = next<double>();
    return result;
  }

  /// Is everything read?
  bool is_at_end() const
  {
    return m_is_binary ? m_at == m_data.size() : m_data.find_first_not_of(" \n", m_at) == std::string::npos;
  }

private:
  const std::string& m_data;
  std::size_t m_at;
  bool m_is_binary;
};

inline long after(const std::string& text, const std::string& key)
{
  const std::size_t at = text.find(key);
  BOOST_REQUIRE_NE(at, std::string::npos);
  return std::stol(text.substr(at + key.size()));
}

} // namespace internal

inline Written read_obj(const std::string& text)
{
  Written file;
  std::istringstream lines(text);
  long curve = -1;
  for(std::string line, key; std::getline(lines, line);) {
    key = line.substr(0, line.find(' '));
    const std::string rest = line.substr((std::min)(key.size() + 1, line.size()));
    internal::Numbers numbers(rest, 0, false);
    if(key == "o") {
      curve = rest.rfind("curve_", 0) == 0 ? std::stol(rest.substr(6)) : -1;
      continue;
    }
    if(key == "v") {
      BOOST_CHECK(file.triangles.empty() && file.lines.empty());
      file.points.push_back(numbers.point());
      BOOST_CHECK(numbers.is_at_end());
      continue;
    }
    std::vector<long> corners;
    while(!numbers.is_at_end()) {
      corners.push_back(numbers.next<long>() - 1);
      BOOST_CHECK(corners.back() >= 0 && corners.back() < static_cast<long>(file.points.size()));
    }
    if(key == "f") {
      BOOST_REQUIRE_EQUAL(corners.size(), 3);
      file.triangles.push_back({corners[0], corners[1], corners[2]});
      file.triangle_curves.push_back(curve);
    } else if(key == "l") {
      BOOST_CHECK_GE(corners.size(), 2);
      file.lines[curve] = corners;
    } else {
      BOOST_CHECK_EQUAL(key, "p");
      file.loose_points.insert(file.loose_points.end(), corners.begin(), corners.end());
    }
  }
  return file;
}

namespace internal {

// The properties of vertices beside their coordinates.
inline std::vector<std::string> ply_value_names(const std::string& header)
{
  std::vector<std::string> names;
  std::istringstream lines(header.substr(header.find("property double z\n"), header.find("element face")));
  std::string line;
  for(std::getline(lines, line); std::getline(lines, line) && line.rfind("property double ", 0) == 0;)
    names.push_back(line.substr(16));
  return names;
}

} // namespace internal

inline Written read_ply(const std::string& text)
{
  Written file;
  file.has_loose_points = false;
  const std::string end = "end_header\n";
  const std::size_t body = text.find(end) + end.size();
  const std::string header = text.substr(0, body);
  const bool is_binary = header.rfind("ply\nformat binary_little_endian 1.0\n", 0) == 0;
  BOOST_CHECK(is_binary || header.rfind("ply\nformat ascii 1.0\n", 0) == 0);
  const bool has_tubes = header.find("vertex_indices\nproperty int curve\n") != std::string::npos;
  const std::vector<std::string> names = internal::ply_value_names(header);
  internal::Numbers numbers(text, body, is_binary);
  for(long i = internal::after(header, "element vertex "); i > 0; --i) {
    file.points.push_back(numbers.point());
    for(const std::string& name : names)
      file.values[name].push_back(numbers.next<double>());
  }
  for(long i = internal::after(header, "element face "); i > 0; --i) {
    BOOST_CHECK_EQUAL(int(numbers.next<std::uint8_t>()), 3);
    file.triangles.emplace_back();
    for(long& corner : file.triangles.back())
      corner = numbers.next<std::int32_t>();
    file.triangle_curves.push_back(has_tubes ? numbers.next<std::int32_t>() : -1);
  }
  for(long i = internal::after(header, "element edge "); i > 0; --i) {
    const long a = numbers.next<std::int32_t>(), b = numbers.next<std::int32_t>(), c = numbers.next<std::int32_t>();
    std::vector<long>& line = file.lines[c];
    if(line.empty())
      line.push_back(a);
    BOOST_CHECK_EQUAL(line.back(), a);
    line.push_back(b);
  }
  BOOST_CHECK(numbers.is_at_end());
  return file;
}

namespace internal {

// The numbers of one array of a VTP file.
class Vtp_array
{
public:
  Vtp_array(const std::string& text, const std::string& group, const std::string& name)
  {
    const std::size_t start = text.find("<" + group);
    BOOST_REQUIRE_NE(start, std::string::npos);
    const std::size_t array = name.empty() ? text.find("<DataArray", start) : text.find("Name=\"" + name, start);
    BOOST_REQUIRE_LT(array, text.find("</" + group, start));
    const std::size_t end_of_tag = text.find('>', array);
    const std::string tag = text.substr(array, end_of_tag - array);
    m_is_binary = tag.find("appended") != std::string::npos;
    if(m_is_binary) {
      const std::string mark = "<AppendedData encoding=\"raw\">\n_";
      const std::size_t at = text.find(mark) + mark.size() + static_cast<std::size_t>(after(tag, "offset=\""));
      m_data = text.substr(at + 8, number_at<std::uint64_t>(text, at));
      BOOST_CHECK_EQUAL(m_data.size(), number_at<std::uint64_t>(text, at));
    } else {
      m_data = text.substr(end_of_tag + 1, text.find("</DataArray>", end_of_tag) - end_of_tag - 1);
    }
  }

  template <class Number>
  std::vector<Number> numbers() const
  {
    std::vector<Number> result;
    for(Numbers numbers(m_data, 0, m_is_binary); !numbers.is_at_end();)
      result.push_back(numbers.next<Number>());
    return result;
  }

private:
  bool m_is_binary = false;
  std::string m_data;
};

inline std::vector<std::string> vtp_value_names(const std::string& text)
{
  std::vector<std::string> names;
  const std::size_t end = text.find("</PointData>");
  if(end != std::string::npos)
    for(std::size_t at = text.find("<PointData"); (at = text.find(" Name=\"", at)) < end;) {
      at += 7;
      names.push_back(text.substr(at, text.find('"', at) - at));
    }
  return names;
}

inline std::vector<std::vector<long>> vtp_cells(const std::string& text, const std::string& kind)
{
  const long count = after(text, "NumberOf" + kind + "=\"");
  std::vector<std::vector<long>> cells;
  if(count == 0 && text.find("<" + kind + ">") == std::string::npos)
    return cells;
  const auto corners = Vtp_array(text, kind, "connectivity").numbers<std::int64_t>();
  std::int64_t start = 0;
  for(std::int64_t end : Vtp_array(text, kind, "offsets").numbers<std::int64_t>()) {
    BOOST_REQUIRE(start < end && end <= static_cast<std::int64_t>(corners.size()));
    cells.emplace_back(corners.begin() + start, corners.begin() + end);
    start = end;
  }
  BOOST_CHECK_EQUAL(start, corners.size());
  BOOST_CHECK_EQUAL(cells.size(), count);
  return cells;
}

} // namespace internal

inline Written read_vtp(const std::string& text)
{
  Written file;
  BOOST_CHECK_NE(text.find("byte_order=\"LittleEndian\""), std::string::npos);
  const auto coordinates = internal::Vtp_array(text, "Points", "").numbers<double>();
  for(std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    file.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  BOOST_CHECK_EQUAL(static_cast<long>(file.points.size()), internal::after(text, "NumberOfPoints=\""));
  for(const std::string& name : internal::vtp_value_names(text)) {
    file.values[name] = internal::Vtp_array(text, "PointData", name + '"').numbers<double>();
    const long components = internal::after(text, "Name=\"" + name + "\" NumberOfComponents=\"");
    BOOST_CHECK_EQUAL(file.values[name].size(), file.points.size() * static_cast<std::size_t>(components));
  }
  const auto curves = internal::Vtp_array(text, "CellData", "curve").numbers<std::int64_t>();
  std::size_t cell = 0;
  for(const auto& point : internal::vtp_cells(text, "Verts")) {
    BOOST_REQUIRE_EQUAL(point.size(), 1);
    file.loose_points.push_back(point[0]);
    ++cell;
  }
  for(const auto& line : internal::vtp_cells(text, "Lines"))
    file.lines[static_cast<long>(curves.at(cell++))] = line;
  for(const auto& face : internal::vtp_cells(text, "Polys")) {
    BOOST_REQUIRE_EQUAL(face.size(), 3);
    file.triangles.push_back({face[0], face[1], face[2]});
    file.triangle_curves.push_back(static_cast<long>(curves.at(cell++)));
  }
  BOOST_CHECK_EQUAL(cell, curves.size());
  return file;
}

namespace internal {

// The JSON and the bytes of a GLB file, with what the specification of glTF 2.0 asks of containers, views and
// accessors.
class Glb_file
{
public:
  using Tree = boost::property_tree::ptree;

  explicit Glb_file(const std::string& file)
  {
    BOOST_REQUIRE_EQUAL(file.substr(0, 4), "glTF");
    BOOST_CHECK_EQUAL(number_at<std::uint32_t>(file, 4), 2);
    BOOST_CHECK_EQUAL(number_at<std::uint32_t>(file, 8), file.size());
    const std::size_t json_size = number_at<std::uint32_t>(file, 12);
    BOOST_CHECK_EQUAL(file.substr(16, 4), "JSON");
    const std::size_t binary = 20 + json_size;
    m_bytes = file.substr(binary + 8);
    BOOST_CHECK_EQUAL(number_at<std::uint32_t>(file, binary), m_bytes.size());
    BOOST_CHECK(file.substr(binary + 4, 4) == std::string("BIN\0", 4));
    BOOST_CHECK(json_size % 4 == 0 && m_bytes.size() % 4 == 0);
    std::istringstream json(file.substr(20, json_size));
    boost::property_tree::read_json(json, m_tree);
    BOOST_CHECK_EQUAL(m_tree.get<std::string>("asset.version"), "2.0");
    BOOST_CHECK_EQUAL(item("buffers", 0).get<std::size_t>("byteLength"), m_bytes.size());
    check_views();
  }

  const Tree& item(const std::string& list, std::size_t i) const
  {
    const Tree& items = m_tree.get_child(list);
    BOOST_REQUIRE_LT(i, items.size());
    return std::next(items.begin(), static_cast<std::ptrdiff_t>(i))->second;
  }

  template <class Number>
  static std::vector<Number> numbers(const Tree& list)
  {
    std::vector<Number> result;
    for(const auto& entry : list)
      result.push_back(entry.second.get_value<Number>());
    return result;
  }

  std::vector<long> root_children(std::vector<double>& translation) const
  {
    const auto roots = numbers<std::size_t>(item("scenes", m_tree.get<std::size_t>("scene")).get_child("nodes"));
    BOOST_REQUIRE_EQUAL(roots.size(), 1);
    translation = numbers<double>(item("nodes", roots[0]).get_child("translation"));
    BOOST_REQUIRE_EQUAL(translation.size(), 3);
    return numbers<long>(item("nodes", roots[0]).get_child("children"));
  }

  std::vector<std::array<double, 3>> positions(std::size_t accessor) const
  {
    const Tree& tree = item("accessors", accessor);
    const auto values = values_of<float>(tree, "5126", "VEC3", 3, "34962");
    const auto least = numbers<double>(tree.get_child("min")), most = numbers<double>(tree.get_child("max"));
    BOOST_REQUIRE(least.size() == 3 && most.size() == 3);
    std::vector<std::array<double, 3>> result;
    std::array<double, 3> low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};
    for(std::size_t i = 0; i < values.size(); i += 3) {
      result.push_back({values[i], values[i + 1], values[i + 2]});
      for(int k = 0; k < 3; ++k) {
        BOOST_CHECK(std::isfinite(result.back()[k]));
        low[k] = (std::min)(low[k], result.back()[k]);
        high[k] = (std::max)(high[k], result.back()[k]);
      }
    }
    for(int k = 0; k < 3; ++k)
      BOOST_CHECK(low[k] == least[k] && high[k] == most[k]);
    return result;
  }

  std::vector<std::uint32_t> indices(std::size_t accessor) const
  {
    return values_of<std::uint32_t>(item("accessors", accessor), "5125", "SCALAR", 1, "34963");
  }

private:
  // Inside the buffer, aligned, one after the other.
  void check_views() const
  {
    std::size_t end = 0;
    for(const auto& view : m_tree.get_child("bufferViews")) {
      BOOST_CHECK_EQUAL(view.second.get<std::size_t>("buffer"), 0);
      BOOST_CHECK_EQUAL(view.second.get<std::size_t>("byteOffset"), end);
      BOOST_CHECK_EQUAL(end % 4, 0);
      BOOST_CHECK_GE(view.second.get<std::size_t>("byteLength"), 1);
      end += view.second.get<std::size_t>("byteLength");
    }
    BOOST_CHECK_EQUAL(end, m_bytes.size());
  }

  template <class Number>
  std::vector<Number> values_of(const Tree& accessor, const std::string& component, const std::string& type,
                                std::size_t width, const std::string& target) const
  {
    BOOST_CHECK_EQUAL(accessor.get<std::string>("componentType"), component);
    BOOST_CHECK_EQUAL(accessor.get<std::string>("type"), type);
    const std::size_t count = accessor.get<std::size_t>("count");
    BOOST_CHECK_GE(count, 1);
    const Tree& view = item("bufferViews", accessor.get<std::size_t>("bufferView"));
    BOOST_CHECK_EQUAL(view.get<std::string>("target"), target);
    BOOST_REQUIRE_EQUAL(view.get<std::size_t>("byteLength"), count * width * 4);
    std::vector<Number> result;
    for(std::size_t i = 0; i < count * width; ++i)
      result.push_back(number_at<Number>(m_bytes, view.get<std::size_t>("byteOffset") + 4 * i));
    return result;
  }

  Tree m_tree;
  std::string m_bytes;
};

} // namespace internal

inline Written read_glb(const std::string& text)
{
  Written file;
  const internal::Glb_file glb(text);
  std::vector<double> move;
  for(long child : glb.root_children(move)) {
    const auto& node = glb.item("nodes", static_cast<std::size_t>(child));
    const std::string name = node.get<std::string>("name");
    const long curve = name.rfind("curve_", 0) == 0 ? std::stol(name.substr(6)) : -1;
    const auto& primitives = glb.item("meshes", node.get<std::size_t>("mesh")).get_child("primitives");
    BOOST_REQUIRE_EQUAL(primitives.size(), 1);
    const auto& primitive = primitives.front().second;
    glb.item("materials", primitive.get<std::size_t>("material"));
    const long first = static_cast<long>(file.points.size());
    for(const auto& p : glb.positions(primitive.get<std::size_t>("attributes.POSITION")))
      file.points.push_back({p[0] + move[0], p[1] + move[1], p[2] + move[2]});
    std::vector<long> all;
    for(long i = first; i < static_cast<long>(file.points.size()); ++i)
      all.push_back(i);
    const int mode = primitive.get<int>("mode");
    if(mode == 4) {
      const auto corners = glb.indices(primitive.get<std::size_t>("indices"));
      BOOST_REQUIRE_EQUAL(corners.size() % 3, 0);
      for(std::size_t i = 0; i < corners.size(); i += 3) {
        BOOST_REQUIRE_LT(*std::max_element(&corners[i], &corners[i] + 3), all.size());
        file.triangles.push_back({first + corners[i], first + corners[i + 1], first + corners[i + 2]});
        file.triangle_curves.push_back(curve);
      }
    } else if(mode == 3) {
      BOOST_CHECK_GE(all.size(), 2);
      file.lines[curve] = all;
    } else {
      BOOST_CHECK_EQUAL(mode, 0);
      file.loose_points.insert(file.loose_points.end(), all.begin(), all.end());
    }
  }
  return file;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_WRITTEN_FILES_H
