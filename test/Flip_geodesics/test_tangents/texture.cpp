// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pictures laid on surfaces: where the surface rolls out they are as long and wide as on paper, also where the map
// tears; and they are read back from files.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/texture_coordinates.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

using Place = std::array<double, 2>;
using Halfedge = Mesh::Halfedge_index;
using Map = Mesh::Property_map<Halfedge, Place>;

Map new_map(Mesh& mesh) { return mesh.add_property_map<Halfedge, Place>("h:texture", Place{{0, 0}}).first; }

// The sides of a face in the picture over those on the surface, the smallest and the largest; and is its side up?
struct Shape_in_picture
{
  double least = std::numeric_limits<double>::infinity(), most = 0;
  bool is_up = false;
};

Shape_in_picture shape(const Mesh& mesh, const Map& map, Mesh::Face_index f, double size)
{
  Shape_in_picture result;
  std::array<std::complex<double>, 3> corners;
  std::size_t i = 0;
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
    corners[i++] = {map[h][0], map[h][1]};
  i = 0;
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) { // its source is the target of the one before
    const double side = size * std::abs(corners[i] - corners[(i + 2) % 3]) /
                        distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    result.least = (std::min)(result.least, side);
    result.most = (std::max)(result.most, side);
    ++i;
  }
  const std::complex<double> first = corners[1] - corners[0], second = corners[2] - corners[1];
  const double longest = (std::max)({std::norm(first), std::norm(second), std::norm(first + second)});
  result.is_up = std::imag(std::conj(first) * second) > 1e-6 * longest; // and no line
  return result;
}

bool has_place(const Mesh& mesh, const Map& map, Mesh::Face_index f) { return std::isfinite(map[mesh.halfedge(f)][0]); }

} // namespace

BOOST_AUTO_TEST_CASE(a_picture_in_the_plane_is_moved_and_turned)
{
  Mesh mesh = to_mesh<Mesh>(jittered_grid(9, 9, Diagonal_rule::ALTERNATING, 0.2, 4));
  const Map map = new_map(mesh);
  const Mesh::Vertex_index middle(grid_vertex(9, 4, 4));
  const Halfedge out = mesh.opposite(mesh.halfedge(middle));
  const Vector along = mesh.point(mesh.target(out)) - mesh.point(middle);
  const double size = 6, turn = 0.3, angle = std::atan2(along.y(), along.x()) + turn;
  const FG::Texture_report report = FG::texture_coordinates(mesh, middle, {out, turn}, size, map);
  BOOST_TEST(report.torn == 0u);
  BOOST_TEST(report.faces > 100u);
  std::size_t faces = 0;
  for(const auto f : mesh.faces()) {
    faces += has_place(mesh, map, f) ? 1 : 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Vector way = mesh.point(mesh.target(h)) - mesh.point(middle);
      BOOST_TEST(std::isnan(map[h][0]) == !has_place(mesh, map, f));
      if(std::abs(way.x()) + std::abs(way.y()) < 4)
        BOOST_TEST(!std::isnan(map[h][0]));
      if(std::isnan(map[h][0]))
        continue;
      const std::complex<double> place = std::complex<double>(way.x(), way.y()) * std::polar(1 / size, -angle);
      BOOST_TEST(std::abs(std::complex<double>(map[h][0] - 0.5, map[h][1] - 0.5) - place) < 1e-13);
    }
  }
  BOOST_TEST(faces == report.faces);
}

BOOST_AUTO_TEST_CASE(round_a_cylinder_it_tears_and_keeps_its_shape)
{
  for(int n : {9, 10}) {
    Mesh mesh = to_mesh<Mesh>(cylinder(n, 8, 1, 4));
    const Map map = new_map(mesh);
    const std::pair<Mesh::Face_index, std::array<double, 3>> middle = {
        Mesh::Face_index(static_cast<unsigned>(mesh.number_of_faces() / 2)), {{0.5, 0.25, 0.25}}};
    const FG::Texture_report report = FG::texture_coordinates(mesh, middle, {mesh.halfedge(middle.first), 0}, 20, map);
    BOOST_TEST(report.faces == mesh.number_of_faces());
    BOOST_TEST(report.torn > 0u);
    for(const auto f : mesh.faces()) {
      const Shape_in_picture s = shape(mesh, map, f, 20);
      BOOST_TEST(s.least > 1 - 1e-9);
      BOOST_TEST(s.most < 1 + 1e-9);
      BOOST_TEST(s.is_up);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_face_is_drawn_across_the_picture)
{
  for(Mesh mesh : {to_mesh<Mesh>(bumpy_sphere(8, 0.2, 5)), to_mesh<Mesh>(torus(24, 12, 2, 1)),
                   to_mesh<Mesh>(cone_disk(12, 5, 2.5))})
  {
    const Map map = new_map(mesh);
    const std::pair<Mesh::Face_index, std::array<double, 3>> middle = {Mesh::Face_index(20), {{0.5, 0.25, 0.25}}};
    const FG::Texture_report report = FG::texture_coordinates(mesh, middle, {mesh.halfedge(middle.first), 0}, 100, map);
    BOOST_TEST(report.faces == mesh.number_of_faces());
    BOOST_TEST(report.torn > 0u);
    BOOST_TEST(report.torn < mesh.number_of_faces() * 2 / 3);
    for(const auto f : mesh.faces())
      BOOST_TEST(shape(mesh, map, f, 100).most < 3);
  }
}

// Behind a saddle all shortest paths arrive in one direction, so that its faces would be lines.
BOOST_AUTO_TEST_CASE(faces_keep_their_sides_up)
{
  for(Mesh mesh : {to_mesh<Mesh>(saddle_disk(16, 6, 4 * pi)), to_mesh<Mesh>(saddle_disk(16, 12, 2.2 * pi)),
                   to_mesh<Mesh>(saddle_disk(12, 12, 3 * pi)), to_mesh<Mesh>(bumpy_sphere(8, 0.2, 5)),
                   to_mesh<Mesh>(torus(24, 12, 2, 1)), to_mesh<Mesh>(cube(3))})
  {
    const Map map = new_map(mesh);
    const std::pair<Mesh::Face_index, std::array<double, 3>> middle = {Mesh::Face_index(20), {{0.5, 0.25, 0.25}}};
    const FG::Texture_report report = FG::texture_coordinates(mesh, middle, {mesh.halfedge(middle.first), 0}, 100, map);
    BOOST_TEST(report.torn > 0u);
    for(const auto f : mesh.faces()) {
      const Shape_in_picture s = shape(mesh, map, f, 100);
      BOOST_TEST(s.is_up);
      BOOST_TEST(s.most < 3);
    }
  }
}

// On convex surfaces corners of faces that the map tears are where their vertices are, or far from there.
BOOST_AUTO_TEST_CASE(torn_faces_hold_on_to_the_others)
{
  for(Mesh mesh : {to_mesh<Mesh>(cube(3)), to_mesh<Mesh>(random_convex_polyhedron(60, 3))}) {
    const Map map = new_map(mesh);
    const std::pair<Mesh::Face_index, std::array<double, 3>> middle = {Mesh::Face_index(20), {{0.5, 0.25, 0.25}}};
    FG::texture_coordinates(mesh, middle, {mesh.halfedge(middle.first), 0}, 100, map);
    const Triangulation t(mesh);
    const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, FG::internal::trace_start(t, mesh, middle));
    std::size_t together = 0;
    for(const auto v : mesh.vertices()) {
      const Place place = logarithm.in_plane(logarithm(t.index(v)));
      for(const Halfedge h : CGAL::halfedges_around_target(v, mesh)) {
        double longest = 0;
        for(const Halfedge side : CGAL::halfedges_around_face(h, mesh))
          longest = (std::max)(longest, distance(mesh.point(mesh.source(side)), mesh.point(mesh.target(side))));
        const double gap = std::hypot(100 * (map[h][0] - 0.5) - place[0], 100 * (map[h][1] - 0.5) - place[1]);
        BOOST_TEST((gap < 1e-12 || gap > 0.499 * longest));
        together += gap < 1e-12 ? 1 : 0;
      }
    }
    BOOST_TEST(together > 2 * mesh.number_of_faces());
  }
}

BOOST_AUTO_TEST_CASE(files_have_the_places_of_corners)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(9, 9, Diagonal_rule::RISING));
  const Map map = new_map(mesh);
  const Mesh::Vertex_index middle(grid_vertex(9, 4, 4));
  const FG::Texture_report report =
      FG::texture_coordinates(mesh, middle, {mesh.opposite(mesh.halfedge(middle)), 0}, 3, map);
  BOOST_TEST(report.faces > 8u);
  BOOST_TEST(report.faces < mesh.number_of_faces());

  std::ostringstream obj;
  FG::IO::write_OBJ(obj, mesh, FG::IO::Texture<Map>(map));
  std::istringstream lines(obj.str());
  std::vector<Place> places;
  std::vector<std::string> faces;
  std::size_t points = 0;
  for(std::string line, word; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> word;
    if(word == "vt") {
      places.emplace_back();
      words >> places.back()[0] >> places.back()[1];
    } else if(word == "f")
      faces.push_back(line);
    points += word == "v" ? 1 : 0;
  }
  BOOST_TEST(points == mesh.number_of_vertices());
  BOOST_TEST(places.size() < 3 * report.faces);
  BOOST_TEST((std::set<Place>(places.begin(), places.end()).size() == places.size()), "places are written once");
  BOOST_REQUIRE(faces.size() == mesh.number_of_faces());
  for(const auto f : mesh.faces()) {
    std::istringstream words(faces[f]);
    std::string word;
    words >> word;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      words >> word;
      const std::string vertex = std::to_string(static_cast<std::size_t>(mesh.target(h)) + 1);
      if(!has_place(mesh, map, f)) {
        BOOST_TEST(word == vertex);
        continue;
      }
      BOOST_TEST_REQUIRE(word.find(vertex + '/') == 0u);
      BOOST_TEST((places.at(std::stoul(word.substr(vertex.size() + 1)) - 1) == map[h]));
    }
  }

  std::ostringstream glb;
  FG::IO::write_GLB(glb, mesh, FG::IO::Texture<Map>(map, "a \"decal\".png"));
  const std::string bytes = glb.str();
  const std::size_t corners = 3 * mesh.number_of_faces();
  std::uint32_t header = 0;
  std::memcpy(&header, bytes.data() + 12, 4);
  BOOST_TEST(bytes.size() == 20 + header + 8 + corners * (12 + 4 + 8));
  const std::string json = bytes.substr(20, header);
  for(const char* text :
      {"\"TEXCOORD_0\":2", "\"type\":\"VEC2\"", "\"uri\":\"a \\\"decal\\\".png\"", "\"baseColorTexture\""})
    BOOST_TEST(json.find(text) != std::string::npos);
  const char* array = bytes.data() + 28 + header;
  std::size_t i = 0;
  const auto number = [&](std::size_t offset) {
    float x = 0;
    std::memcpy(&x, array + offset, 4);
    return x;
  };
  for(const auto f : mesh.faces())
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Place wanted = has_place(mesh, map, f) ? Place{{map[h][0], 1 - map[h][1]}} : Place{{-1, -1}};
      for(std::size_t k = 0; k < 2; ++k) {
        BOOST_TEST(number(corners * 16 + 8 * i + 4 * k) == static_cast<float>(wanted[k]));
        BOOST_TEST(std::abs(number(12 * i + 4 * k) - (mesh.point(mesh.target(h))[static_cast<int>(k)] - 4.5)) < 1e-6);
      }
      ++i;
    }
  BOOST_CHECK_THROW(FG::IO::write_GLB(glb, mesh, FG::IO::Texture<Map>(map, "a\n")), FG::File_write_error);
  mesh.point(middle) = Point(std::numeric_limits<double>::infinity(), 0, 0);
  BOOST_CHECK_THROW(FG::IO::write_GLB(glb, mesh, FG::IO::Texture<Map>(map)), FG::Invalid_coordinate_error);
}

BOOST_AUTO_TEST_CASE(pictures_without_size_or_place_are_refused)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::RISING));
  const Map map = new_map(mesh);
  const Mesh::Vertex_index middle(grid_vertex(3, 1, 1));
  const Halfedge out = mesh.opposite(mesh.halfedge(middle));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(double size : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW(FG::texture_coordinates(mesh, middle, {out, 0}, size, map), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::texture_coordinates(mesh, middle, {out, nan}, 1, map), FG::Invalid_parameter_error);
  const Halfedge elsewhere = mesh.halfedge(Mesh::Face_index(17)); // the last one
  BOOST_CHECK_THROW(FG::texture_coordinates(mesh, Mesh::Vertex_index(0), {elsewhere, 0}, 1, map),
                    FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::texture_coordinates(mesh, Mesh::Vertex_index(999), {out, 0}, 1, map),
                    FG::Vertex_out_of_range_error);
}
