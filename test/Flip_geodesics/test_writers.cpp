// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE writers

#include "test_writers/writer_setting.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(surface_curves_and_points_are_read_back)
{
  const Mesh mesh = sample_mesh();
  const Polylines curves = sample_curves();
  const Polyline loose = {Point(3, 3, 3), Point(-1, 0.7, 0)};
  const std::size_t vertices = mesh.number_of_vertices();
  for(const Format& format : formats()) {
    BOOST_TEST_CONTEXT(format.name << (format.is_binary ? " in bytes" : " in text"))
    {
      const Written file = format.read(format.text(mesh, curves, loose));
      BOOST_CHECK_EQUAL(file.points.size(), vertices + 8);
      check_points(format, file.points, Polyline(mesh.points().begin(), mesh.points().end()), 0);
      check_points(format, file.points, curves[0], vertices);
      check_points(format, file.points, curves[2], vertices + 3);
      check_points(format, file.points, curves[3], vertices + 4);
      check_points(format, file.points, loose, vertices + 6);
      BOOST_REQUIRE_EQUAL(file.triangles.size(), mesh.number_of_faces());
      for(const auto f : mesh.faces()) {
        std::array<long, 3> corners;
        auto corner = corners.begin();
        for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
          *corner++ = static_cast<long>(v.idx());
        BOOST_CHECK(file.triangles[f.idx()] == corners);
      }
      const long n = static_cast<long>(vertices);
      const std::map<long, std::vector<long>> lines = {{0, {n, n + 1, n + 2}}, {3, {n + 4, n + 5}}};
      BOOST_CHECK(file.lines == lines);
      if(file.has_loose_points)
        BOOST_CHECK((file.loose_points == std::vector<long>{n + 3, n + 6, n + 7}));
    }
  }
}

BOOST_AUTO_TEST_CASE(corners_with_equal_texture_coordinates_share_a_line_of_obj)
{
  using Corner_map = Mesh::Property_map<Mesh::Halfedge_index, std::array<double, 2>>;
  Mesh mesh = sample_mesh();
  const Corner_map corners = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>("h:texture").first;
  for(const auto h : mesh.halfedges())
    corners[h] = {mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y()};
  std::ostringstream out;
  FG::IO::write_OBJ(out, mesh, FG::IO::Texture<Corner_map>(corners));

  // The coordinates are those of the vertices in the plane.
  std::istringstream in(out.str());
  std::vector<std::array<double, 2>> points, texture;
  std::string word;
  while(in >> word) {
    double x = 0, y = 0, z = 0;
    if(word == "v" && in >> x >> y >> z)
      points.push_back({x, y});
    else if(word == "vt" && in >> x >> y)
      texture.push_back({x, y});
    else if(const auto slash = word.find('/'); slash != std::string::npos)
      BOOST_CHECK(points.at(std::stoul(word) - 1) == texture.at(std::stoul(word.substr(slash + 1)) - 1));
  }
  BOOST_CHECK_EQUAL(texture.size(), mesh.number_of_vertices());
}

BOOST_AUTO_TEST_CASE(doubles_come_back_bit_by_bit_whatever_the_stream_is_set_to)
{
  Polyline points;
  for(double x : awkward_numbers())
    points.emplace_back(x, -x, 1);
  for(const Format& format : formats()) {
    const Polyline used = format.is_of_floats ? sample_curves()[0] : points;
    const std::string plain = format.text(Polylines{used}, used);
    const Written file = format.read(plain);
    check_points(format, file.points, used, 0);
    check_points(format, file.points, used, used.size());

    std::ostringstream odd;
    odd.imbue(std::locale(std::locale::classic(), new German_numbers));
    odd << std::fixed << std::showpos << std::hex;
    odd.precision(2);
    odd.width(30);
    format.write(odd, Polylines{used}, used);
    BOOST_CHECK(odd.str() == plain);
    BOOST_CHECK(odd.precision() == 2 && (odd.flags() & std::ios_base::hex) != 0);
    odd.str("");
    odd.width(0);
    odd << std::dec << 12345.5;
    BOOST_CHECK_EQUAL(odd.str(), "+12.345,50");
  }
}

BOOST_AUTO_TEST_CASE(the_locale_of_the_program_has_no_influence)
{
  for(const Format& format : formats()) {
    const std::string plain = format.text(sample_curves());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German_numbers));
    const std::string german = format.text(sample_curves());
    std::locale::global(before);
    BOOST_CHECK(german == plain);
  }
}

BOOST_AUTO_TEST_CASE(shapes_have_their_names)
{
  const Polyline loose = {Point(3, 3, 3)};
  std::ostringstream obj, surface_alone;
  FG::IO::write_OBJ(obj, sample_mesh(), sample_curves(), loose);
  std::vector<std::string> names;
  std::istringstream lines(obj.str());
  for(std::string line; std::getline(lines, line);)
    if(line.compare(0, 2, "o ") == 0)
      names.push_back(line.substr(2));
  BOOST_CHECK((names == std::vector<std::string>{"surface", "curve_0", "curve_2", "curve_3", "points"}));
  FG::IO::write_VTP(surface_alone, sample_mesh());
  BOOST_CHECK(surface_alone.str().find("<Verts>") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_have_their_lowest_byte_first)
{
  const Polylines curve = {{Point(1, -2, 0.5), Point(1, 0, 0)}};
  std::ostringstream ply, vtp, glb;
  FG::IO::write_PLY(ply, curve);
  const std::string one("\0\0\0\0\0\0\xf0\x3f", 8), minus_two("\0\0\0\0\0\0\0\xc0", 8), half("\0\0\0\0\0\0\xe0\x3f", 8);
  const std::size_t start = ply.str().find("end_header\n") + 11;
  BOOST_CHECK(ply.str().compare(start, 24, one + minus_two + half) == 0);
  BOOST_CHECK(ply.str().substr(start + 48) == std::string("\0\0\0\0\1\0\0\0\0\0\0\0", 12));
  FG::IO::write_VTP(vtp, curve);
  BOOST_CHECK(vtp.str().find("_" + std::string("\60\0\0\0\0\0\0\0", 8) + one + minus_two + half) != std::string::npos);
  FG::IO::write_GLB(glb, Polylines{{Point(1, 0, 0), Point(-1, 0, 0)}});
  BOOST_CHECK(glb.str().compare(0, 8, std::string("glTF\2\0\0\0", 8)) == 0);
  BOOST_CHECK(glb.str().substr(glb.str().size() - 24) ==
              std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\x80\xbf\0\0\0\0\0\0\0\0", 24));
}

BOOST_AUTO_TEST_CASE(the_readers_of_cgal_read_the_surface)
{
  Mesh mesh = sample_mesh();
  Mesh::size_type i = 0;
  for(double x : awkward_numbers())
    if(std::abs(x) > 1e-300) // smaller ones are no numbers to streams
      mesh.point(Mesh::Vertex_index(i++)) = Point(x, 1, -x);
  for(const Format& format : formats()) {
    const std::string name = format.name;
    if(name != "OBJ" && name != "PLY")
      continue; // for the others it has none, or one that needs VTK
    const Polylines curves = name == "PLY" ? sample_curves() : Polylines{{Point(1, 1, 1)}}; // it takes no lines in OBJ
    std::istringstream in(format.text(mesh, curves));
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    BOOST_CHECK(name == "OBJ" ? CGAL::IO::read_OBJ(in, points, polygons) : CGAL::IO::read_PLY(in, points, polygons));
    BOOST_REQUIRE_EQUAL(points.size(), mesh.number_of_vertices() + (name == "PLY" ? 6 : 1));
    BOOST_CHECK(std::equal(mesh.points().begin(), mesh.points().end(), points.begin()));
    BOOST_REQUIRE_EQUAL(polygons.size(), mesh.number_of_faces());
    for(const auto f : mesh.faces()) {
      std::vector<std::size_t> corners;
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        corners.push_back(v);
      BOOST_CHECK(polygons[f] == corners);
    }
  }
}

BOOST_AUTO_TEST_CASE(curves_are_counted_over_all_ranges_and_any_range_will_do)
{
  const std::list<std::array<Point, 2>> first = {{Point(0, 0, 0), Point(1, 0, 0)}, {Point(0, 1, 0), Point(1, 1, 0)}};
  const Polylines second = sample_curves();
  // Polylines that do not exist before they are asked for.
  const auto made = boost::irange(0, 3) | boost::adaptors::transformed([](int i) {
                      return Polyline{Point(i, 0, 0), Point(i, 1, 0), Point(i, 2, 0)};
                    });
  for(const Format& format : formats()) {
    const Written file = format.read(format.text(first, second, made));
    std::vector<long> numbers;
    for(const auto& line : file.lines)
      numbers.push_back(line.first);
    BOOST_CHECK((numbers == std::vector<long>{0, 1, 2, 5, 6, 7, 8}));
    check_points(format, file.points, {Point(2, 0, 0), Point(2, 1, 0), Point(2, 2, 0)}, file.points.size() - 3);
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_without_points_is_written_with_a_map)
{
  const Mesh_soup soup = grid(3, 2, Diagonal_rule::ALTERNATING, [](int i, int j) { return 0.3 * i * i - 0.1 * j; });
  const Mesh_archetype mesh(soup);
  std::ostringstream out, usual;
  FG::IO::write_OBJ(out, mesh, CGAL::parameters::vertex_point_map(Archetype_point_map{&mesh}));
  FG::IO::write_OBJ(usual, to_mesh<Mesh>(soup));
  Written found = read_obj(out.str()), expected = read_obj(usual.str());
  for(Written* file : {&found, &expected}) // its faces start at other corners
    for(auto& t : file->triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  BOOST_CHECK(found.points == expected.points);
  BOOST_CHECK(found.triangles == expected.triangles);
}

BOOST_AUTO_TEST_CASE(digits_can_be_chosen)
{
  std::ostringstream out;
  FG::IO::write_OBJ(out, Polyline{Point(1.0 / 3, 0, 2)}, CGAL::parameters::stream_precision(4));
  BOOST_CHECK_EQUAL(out.str(), "v 0.3333 0 2\no points\np 1\n");
}
