// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Values at the vertices of a mesh.

#include "test_writers/writer_setting.h"

using namespace Flip_geodesics_test;

namespace {

using Vertex = Mesh::Vertex_index;

std::vector<Format> formats_with_values()
{
  std::vector<Format> result;
  std::copy_if(formats().begin(), formats().end(), std::back_inserter(result),
               [](const Format& f) { return f.name == std::string("PLY") || f.name == std::string("VTP"); });
  return result;
}

template <class Function>
auto map_of(const Function& f)
{
  return boost::make_function_property_map<Vertex>(f);
}

// The numbers of a vector, which are one array in VTP and three properties in PLY.
std::vector<double> vectors(const Written& file, const std::string& name)
{
  if(file.values.count(name) != 0)
    return file.values.at(name);
  std::vector<double> result;
  for(std::size_t i = 0; i < file.points.size(); ++i)
    for(const char* axis : {"_x", "_y", "_z"})
      result.push_back(file.values.at(name + axis).at(i));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(values_at_vertices_are_read_back)
{
  const Mesh mesh = sample_mesh();
  const auto number = map_of([](Vertex v) { return static_cast<int>(v.idx()) - 2; });
  const auto distance = map_of([](Vertex v) { return 1.0 / (3 + static_cast<double>(v.idx())); });
  const auto direction = map_of([&](Vertex v) { return mesh.point(v) - Point(1, 2, 3); });
  const auto pair = map_of([](Vertex v) { return std::array<double, 2>{{0.5, static_cast<double>(v.idx())}}; });
  for(const Format& format : formats_with_values()) {
    const Written file = format.read(
        format.text(FG::IO::Vertex_values("nearest_source", number), mesh, FG::IO::Vertex_values("distance", distance),
                    FG::IO::Vertex_values("direction", direction), FG::IO::Vertex_values("pair", pair)));
    BOOST_REQUIRE_EQUAL(file.points.size(), mesh.number_of_vertices());
    BOOST_CHECK_EQUAL(file.triangles.size(), mesh.number_of_faces());
    const std::vector<double> found = vectors(file, "direction");
    BOOST_REQUIRE_EQUAL(found.size(), 3 * mesh.number_of_vertices());
    for(Vertex v : mesh.vertices()) {
      BOOST_CHECK_EQUAL(file.values.at("nearest_source").at(v), get(number, v));
      BOOST_CHECK_EQUAL(file.values.at("distance").at(v), get(distance, v));
      for(int k = 0; k < 3; ++k)
        BOOST_CHECK_EQUAL(found[3 * v + static_cast<std::size_t>(k)], get(direction, v)[k]);
    }
    const bool is_vtp = format.name == std::string("VTP");
    const std::vector<double>& second = file.values.at(is_vtp ? "pair" : "pair_1");
    BOOST_CHECK_EQUAL(second.at(is_vtp ? 5 : 2), 2);
  }
}

BOOST_AUTO_TEST_CASE(points_beside_the_mesh_have_no_values)
{
  const Mesh mesh = sample_mesh();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto distance = map_of([&](Vertex v) { return v.idx() == 3 ? infinity : 1.0; });
  const auto other = map_of([](Vertex v) { return static_cast<double>(v.idx()); });
  for(const Format& format : formats_with_values()) {
    std::ostringstream out;
    if(!format.is_binary) {
      BOOST_CHECK_THROW(format.write(out, mesh, FG::IO::Vertex_values("distance", distance)), FG::File_write_error);
      BOOST_CHECK_THROW(format.write(out, sample_curves(), mesh, FG::IO::Vertex_values("other", other)),
                        FG::File_write_error);
      BOOST_CHECK(out.str().empty());
      continue;
    }
    const Written file = format.read(
        format.text(sample_curves(), mesh, FG::IO::Tubes(0.1), FG::IO::Vertex_values("distance", distance)));
    const std::vector<double>& values = file.values.at("distance");
    BOOST_REQUIRE_EQUAL(values.size(), file.points.size());
    const std::size_t first = values.size() - mesh.number_of_vertices();
    for(std::size_t i = 0; i < values.size(); ++i)
      BOOST_CHECK(i < first ? std::isnan(values[i]) : values[i] == (i == first + 3 ? infinity : 1));
  }
}

BOOST_AUTO_TEST_CASE(names_of_values_are_checked)
{
  const Mesh mesh = sample_mesh();
  const auto one = map_of([](Vertex) { return 1.0; });
  for(const Format& format : formats_with_values()) {
    std::ostringstream out;
    for(const char* name : {"", "two words", "a\"b", "a<b", "a/", "a:", "a@", "a[", "a^", "a`", "a{"})
      BOOST_CHECK_THROW(format.write(out, mesh, FG::IO::Vertex_values(name, one)), FG::Invalid_parameter_error);
    BOOST_CHECK_THROW(format.write(out, mesh, FG::IO::Vertex_values("a", one), FG::IO::Vertex_values("a", one)),
                      FG::Invalid_parameter_error);
    if(format.name == std::string("PLY"))
      BOOST_CHECK_THROW(format.write(out, mesh, FG::IO::Vertex_values("y", one)), FG::Invalid_parameter_error);
    BOOST_CHECK(out.str().empty());
  }
  for(const Format& format : formats_with_values())
    BOOST_CHECK_EQUAL(format.read(format.text(mesh, FG::IO::Vertex_values("AZ_az09", one))).values.count("AZ_az09"), 1);
  for(const Format& format : formats()) // the other formats take no notice
    BOOST_CHECK(!format.text(mesh, FG::IO::Vertex_values("a", one)).empty());
}

BOOST_AUTO_TEST_CASE(the_reader_of_cgal_reads_values)
{
  const Mesh mesh = sample_mesh();
  std::stringstream file;
  FG::IO::write_PLY(file, mesh,
                    FG::IO::Vertex_values("quality", map_of([](Vertex v) { return 0.1 * static_cast<int>(v.idx()); })));
  Mesh found;
  std::string comments;
  BOOST_REQUIRE(CGAL::IO::read_PLY(file, found, comments));
  const std::vector<std::string> names = found.properties<Vertex>();
  BOOST_CHECK(std::find(names.begin(), names.end(), "v:quality") != names.end());
  BOOST_CHECK_EQUAL(found.number_of_faces(), mesh.number_of_faces());
}
