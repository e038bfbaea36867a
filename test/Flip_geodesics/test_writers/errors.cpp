// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What cannot be written is an error, and nothing that was there is lost.

#include "test_writers/writer_setting.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(nothing_to_write_is_an_error)
{
  for(const Format& format : formats()) {
    const auto check = [&](const auto& part) {
      BOOST_CHECK(elements_of_error<FG::File_write_error>([&](std::ostream& out) { format.write(out, part); }).empty());
    };
    check(Mesh());
    check(Polyline());
    check(Polylines());
    check(Polylines(3));
  }
  // Vertices alone are something, but not where there are only faces.
  Mesh vertex;
  vertex.add_vertex(Point(1, 2, 3));
  std::ostringstream out;
  BOOST_CHECK_THROW(FG::IO::write_GLB(out, vertex), FG::File_write_error);
  for(const Format& format : formats())
    if(!format.is_of_floats)
      BOOST_CHECK_EQUAL(format.read(format.text(vertex)).points.size(), 1);
  // Beside something, what is empty does no harm.
  BOOST_CHECK_EQUAL(read_glb(formats().front().text(vertex, Polylines(2), Polyline{Point(1, 2, 3)})).points.size(), 1);
}

BOOST_AUTO_TEST_CASE(points_that_are_no_points_are_errors)
{
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
    for(const Format& format : formats()) {
      Mesh mesh = sample_mesh();
      Polylines curves = sample_curves();
      Polyline loose = {Point(0, 0, 0), Point(1, 1, 1)};
      const auto elements = [&](const auto&... options) {
        return elements_of_error<FG::Invalid_coordinate_error>(
            [&](std::ostream& out) { format.write(out, mesh, curves, loose, options...); });
      };
      loose[1] = Point(0, bad, 0);
      BOOST_CHECK(elements() == Elements{1});
      curves[3][1] = Point(0, 0, bad);
      BOOST_CHECK((elements() == Elements{3, 1}));
      BOOST_CHECK((elements(FG::IO::Tubes(0.1)) == Elements{3, 1}));
      mesh.point(Mesh::Vertex_index(5)) = Point(bad, 0, 0);
      BOOST_CHECK(elements() == Elements{5});
    }
}

BOOST_AUTO_TEST_CASE(points_beyond_floats_are_an_error_of_glb)
{
  const auto elements = [](const Polylines& curves) {
    return elements_of_error<FG::Invalid_coordinate_error>([&](std::ostream& out) { FG::IO::write_GLB(out, curves); });
  };
  BOOST_CHECK((elements({{Point(0, 0, 0), Point(1, 1, 1), Point(0, 1e60, 0)}}) == Elements{0, 0}));
  BOOST_CHECK((elements({{Point(-1.7e308, 0, 0), Point(1.7e308, 0, 0)}}) == Elements{0, 0}));
  Mesh mesh = sample_mesh();
  BOOST_CHECK((elements_of_error<FG::Invalid_coordinate_error>([&](std::ostream& out) {
                 FG::IO::write_GLB(out, mesh, Polylines{{}, {Point(0, 0, 0), Point(0, 4e38, 0)}});
               }) == Elements{1, 1}));
  // Far from the origin they are as good as at it.
  const Written file = read_glb(formats().front().text(Polylines{{Point(1e60, 0, 0), Point(1e60, 1, 0)}}));
  BOOST_CHECK_EQUAL(file.points[1][0], 1e60);
}

BOOST_AUTO_TEST_CASE(meshes_that_are_none_are_errors)
{
  Mesh quad;
  std::vector<Mesh::Vertex_index> corners;
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    corners.push_back(quad.add_vertex(p));
  quad.add_face(corners);
  Mesh with_garbage = sample_mesh();
  with_garbage.remove_vertex(with_garbage.add_vertex(Point(0, 0, 0)));
  for(const Format& format : formats()) {
    const auto elements =
        elements_of_error<FG::Invalid_mesh_error>([&](std::ostream& out) { format.write(out, quad); });
    BOOST_CHECK_EQUAL(elements.size(), 4);
    BOOST_CHECK(
        elements_of_error<FG::Invalid_mesh_error>([&](std::ostream& out) { format.write(out, with_garbage); }).empty());
  }
}

BOOST_AUTO_TEST_CASE(more_than_32_bits_can_count_is_an_error)
{
  static const Point point(0, 0, 0); // all points are this one
  const auto points = [](std::size_t n) {
    return boost::irange(std::size_t(0), n) |
           boost::adaptors::transformed([](std::size_t) -> const Point& { return point; });
  };
  const auto is_refused = [](const auto& write) { return elements_of_error<FG::File_write_error>(write).empty(); };
  constexpr std::size_t bytes_of_glb = 4294967295;
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_GLB(out, points(bytes_of_glb / 12 + 1)); }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { // each of them alone would fit
    FG::IO::write_GLB(out, points(bytes_of_glb / 20), points(bytes_of_glb / 20));
  }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_PLY(out, points(2147483648)); }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_PLY(out, points(1073741824), points(1073741824)); }));
}

BOOST_AUTO_TEST_CASE(a_stream_that_fails_is_an_error)
{
  const Mesh mesh = sample_mesh();
  for(const Format& format : formats()) {
    const std::string all = format.text(mesh, sample_curves());
    for(std::size_t space : {std::size_t(0), std::size_t(7), all.size() / 2, all.size() - 1}) {
      Small_disk disk(space);
      std::ostream out(&disk);
      BOOST_CHECK_THROW(format.write(out, mesh, sample_curves()), FG::File_write_error);
      BOOST_CHECK(out.bad());
    }
    Small_disk disk(all.size());
    std::ostream out(&disk);
    BOOST_CHECK_NO_THROW(format.write(out, mesh, sample_curves()));
    std::ostringstream failed;
    failed.setstate(std::ios_base::failbit);
    BOOST_CHECK_THROW(format.write(failed, mesh), FG::File_write_error);
    BOOST_CHECK(failed.str().empty());
  }
}

BOOST_AUTO_TEST_CASE(files_are_written_and_kept_on_errors)
{
  const auto content = [](const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string name = "test_writers_result", nowhere = "no_such_folder/x", full = "/dev/full";
  for(const Format& format : formats()) {
    format.write(name, sample_mesh(), sample_curves());
    const std::string expected = format.text(sample_mesh(), sample_curves());
    BOOST_CHECK(content(name) == expected);
    BOOST_CHECK_THROW(format.write(name, Polyline()), FG::File_write_error);
    BOOST_CHECK(content(name) == expected);
    const auto names = [](const std::string& file) {
      return [file](const std::exception& error) { return std::string(error.what()).rfind(file + ": c", 0) == 0; };
    };
    BOOST_CHECK_EXCEPTION(format.write(nowhere, sample_mesh()), FG::File_write_error, names(nowhere));
    if(std::ofstream(full))
      BOOST_CHECK_EXCEPTION(format.write(full, sample_mesh()), FG::File_write_error, names(full));
  }
  std::remove(name.c_str());
}
