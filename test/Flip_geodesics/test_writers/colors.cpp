// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Colors of the surface, of curves and of points.

#include "test_writers/writer_setting.h"

using namespace Flip_geodesics_test;

namespace {

const Polylines curves = {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)}, {Point(0, 0, 1), Point(0, 0, 2)}};

const Format& format(const std::string& name, bool is_binary)
{
  return *std::find_if(formats().begin(), formats().end(),
                       [&](const Format& f) { return f.name == name && f.is_binary == is_binary; });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

// The decoding function of IEC 61966-2-1, the inverse of what the writers compute.
BOOST_AUTO_TEST_CASE(components_of_colors_are_encoded_as_srgb)
{
  for(int byte = 0; byte < 256; ++byte) {
    const double x = byte / 255.0, linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    const FG::internal::Material material = {"gray", {{linear, 0, 1}}};
    BOOST_CHECK((material.bytes() == std::array<std::uint8_t, 3>{{static_cast<std::uint8_t>(byte), 0, 255}}));
  }
}

BOOST_AUTO_TEST_CASE(vertices_and_edges_of_ply_have_colors)
{
  const Mesh mesh = sample_mesh();
  const std::string text = format("PLY", false).text(mesh, curves, FG::IO::Colors());
  const std::size_t at = text.find("property uchar red");
  BOOST_REQUIRE_NE(at, std::string::npos);
  BOOST_CHECK(has(text.substr(at + 1), "property uchar red"));
  BOOST_CHECK(has(text, "1 1 0 221 56 56\n"));  // the end of the first curve
  BOOST_CHECK(has(text, "0 0 2 39 124 203\n")); // and of the second one
  BOOST_CHECK(has(text, " 0 221 56 56\n"));     // an edge of the first one
  const Format& binary = format("PLY", true);
  const std::string plain = binary.text(mesh, curves), colored = binary.text(mesh, curves, FG::IO::Colors());
  const std::size_t header = 2 * std::string("property uchar red\nproperty uchar green\nproperty uchar blue\n").size();
  BOOST_CHECK_EQUAL(colored.size() - plain.size(), header + 3 * (mesh.number_of_vertices() + 5 + 3));
  const auto red = boost::make_function_property_map<Mesh::Vertex_index>([](Mesh::Vertex_index) { return 1.0; });
  BOOST_CHECK_THROW(binary.text(mesh, FG::IO::Vertex_values("red", red), FG::IO::Colors()),
                    FG::Invalid_parameter_error);
  BOOST_CHECK_NO_THROW(binary.text(mesh, FG::IO::Vertex_values("red", red)));
}

BOOST_AUTO_TEST_CASE(cells_of_vtp_have_colors)
{
  const Mesh mesh = sample_mesh();
  const std::string text = format("VTP", false).text(mesh, curves, FG::IO::Colors(), FG::IO::Tubes(0.1, 3));
  const std::size_t at = text.find("Name=\"color\" NumberOfComponents=\"3\"");
  BOOST_REQUIRE_NE(at, std::string::npos);
  std::istringstream numbers(text.substr(text.find('>', at) + 1));
  std::map<std::array<int, 3>, std::size_t> counts;
  for(std::array<int, 3> color; numbers >> color[0] >> color[1] >> color[2];)
    ++counts[color];
  const std::size_t tube_of_two_pieces = 2 * 6 + 2 * 3, tube_of_one = 6 + 2 * 3;
  BOOST_CHECK_EQUAL(counts.size(), 3);
  BOOST_CHECK_EQUAL((counts[{{221, 56, 56}}]), tube_of_two_pieces);
  BOOST_CHECK_EQUAL((counts[{{39, 124, 203}}]), tube_of_one);
  const Written file = format("VTP", true).read(format("VTP", true).text(mesh, curves, FG::IO::Colors()));
  BOOST_CHECK_EQUAL(file.lines.size(), 2);
  BOOST_CHECK_EQUAL(file.triangles.size(), mesh.number_of_faces());
}

BOOST_AUTO_TEST_CASE(objects_of_obj_have_materials_of_a_library)
{
  std::ostringstream library;
  FG::IO::write_MTL(library);
  const Format& obj = format("OBJ", false);
  const std::string text = obj.text(sample_mesh(), curves, FG::IO::Colors("curves.mtl"));
  BOOST_CHECK_EQUAL(text.rfind("mtllib curves.mtl\n", 0), 0);
  for(const char* material : {"surface", "curve_a", "curve_b"}) {
    BOOST_CHECK(has(text, std::string("\nusemtl ") + material + '\n'));
    BOOST_CHECK(has(library.str(), std::string("newmtl ") + material + '\n'));
  }
  BOOST_CHECK(has(library.str(), "Kd 0.866666666666667 0.219607843137255 0.219607843137255\n"));
  BOOST_CHECK_EQUAL(obj.text(sample_mesh(), curves, FG::IO::Colors()), obj.text(sample_mesh(), curves));
}

BOOST_AUTO_TEST_CASE(glb_has_its_colors_anyway)
{
  const Format& glb = format("GLB", true);
  BOOST_CHECK(glb.text(sample_mesh(), curves, FG::IO::Colors("x")) == glb.text(sample_mesh(), curves));
}
