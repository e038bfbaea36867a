// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_READER_TARGETS_H
#define FLIP_GEODESICS_TEST_READER_TARGETS_H

#include "input/curve_input.h"
#include "input/data_input.h"
#include "input/mesh_input.h"
#include "input/point_input.h"

#include <CGAL/Flip_geodesics/IO/network.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What is done with any bytes at all, for each reader of the program and of the library: they are read, and then either
// what was read is right in itself, or there is an error of one line. A target throws if it is otherwise.
namespace reader_targets {

inline void require(bool condition, const std::string& what)
{
  if(!condition)
    throw std::logic_error(what);
}

/// A message is one line of printable text, not too long.
inline void check_message(const std::string& message)
{
  require(!message.empty() && message == program::without_controls(message), "a message is not printable: " + message);
  require(message.size() < 600, "a message is too long: " + message);
}

/// Calls a function that may say that its input is bad, and nothing else.
template <class Function>
void call_reader(const Function& read)
{
  try {
    read();
  } catch(const program::Bad_input& error) {
    check_message(error.what());
  }
}

inline void check_soup_is_whole(const program::Soup& soup)
{
  for(const auto& p : soup.points)
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()), "a coordinate is not finite");
  for(const std::vector<std::size_t>& face : soup.faces)
    for(std::size_t v : face)
      require(v < soup.points.size(), "a face has a vertex that does not exist");
}

/// A repair leaves triangles that come from polygons of the file, and says what it did.
inline void check_repaired(const program::Input_mesh& repaired)
{
  const program::Mesh& mesh = repaired.mesh();
  require(mesh.is_valid() && CGAL::is_triangle_mesh(mesh) && mesh.number_of_faces() > 0, "a repair leaves no mesh");
  for(const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()), "a coordinate is not finite");
    require(!mesh.is_isolated(v) || !repaired.comes_from(v, v), "a vertex without faces comes from itself");
  }
  for(const auto f : mesh.faces())
    require(repaired.face_in_file(f) < repaired.number_of_faces_in_file(), "a face comes from no polygon");
  for(const std::string& remark : repaired.remarks())
    check_message(remark);
}

/// The bytes of a mesh in the format of an extension.
inline void read_mesh(const std::string& extension, const std::string& bytes)
{
  const program::Input_text input = {"fuzz." + extension, bytes};
  call_reader([&] {
    check_soup_is_whole(program::read_soup(input));
    const program::Input_mesh mesh(program::read_mesh(input));
    require(mesh.mesh().is_valid(), "a mesh is not valid");
    if(extension == "obj")
      program::read_seams(mesh, input);
  });
  program::Progress progress;
  call_reader([&] { check_repaired(program::repair_mesh(input, 0, progress)); });
}

inline void read_off(const std::string& bytes) { read_mesh("off", bytes); }
inline void read_obj(const std::string& bytes) { read_mesh("obj", bytes); }
inline void read_ply(const std::string& bytes) { read_mesh("ply", bytes); }
inline void read_stl(const std::string& bytes) { read_mesh("stl", bytes); }
inline void read_ts(const std::string& bytes) { read_mesh("ts", bytes); }

/// An octahedron: vertices 0 and 5 are opposite, and 1 to 4 lie around.
inline const program::Input_mesh& octahedron()
{
  static const program::Input_mesh mesh(program::read_mesh(
      {"octahedron.off", "OFF 6 8 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 -1\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n"
                         "3 5 2 1\n3 5 3 2\n3 5 4 3\n3 5 1 4\n"}));
  return mesh;
}

inline void check_curve(const program::Curve_request& curve)
{
  const program::Mesh& mesh = octahedron();
  check_message(curve.name);
  for(const auto v : curve.vertices)
    require(v.is_valid() && v.idx() < static_cast<program::Index>(mesh.number_of_vertices()),
            "a vertex does not exist");
  for(const auto& point : curve.points) {
    const auto h = point.halfedge;
    require(h.is_valid() && h.idx() < static_cast<program::Index>(mesh.number_of_halfedges()),
            "a halfedge does not exist");
    double sum = 0;
    for(double weight : point.weights) {
      require(weight >= 0, "a weight is not positive");
      sum += weight;
    }
    require(std::abs(sum - 1) < 1e-9, "the weights of a point do not sum to 1");
  }
}

/// Bytes of which the first says what file of curves on the octahedron the others are.
inline void read_curves(const std::string& bytes)
{
  const program::Input_mesh& mesh = octahedron();
  const char kind = bytes.empty() ? ' ' : bytes[0];
  const program::Input_text input = {kind == 'w' ? "fuzz.polylines.txt" : "fuzz.txt",
                                     bytes.substr(bytes.empty() ? 0 : 1)};
  call_reader([&] {
    const program::Network_request request =
        kind == 'n'                  ? program::read_network(mesh, input)
        : kind == 's'                ? program::read_segmentation(mesh, input, false)
        : kind == 'f'                ? program::read_segmentation(mesh, input, true)
        : kind == 'e'                ? program::Network_request{program::read_curves(mesh, input, false), {}, {}}
        : kind == 'l'                ? program::Network_request{program::read_curves(mesh, input, true), {}, {}}
        : kind == 'q'                ? program::Network_request{program::read_point_curves(mesh, input, false), {}, {}}
        : kind == 'b'                ? program::Network_request{program::read_point_curves(mesh, input, true), {}, {}}
        : kind == 'd' || kind == 'w' ? program::Network_request{program::read_drawn_curves(mesh, input), {}, {}}
                                     : program::Network_request{program::read_pairs(mesh, input), {}, {}};
    require(!request.curves.empty(), "the file contains no curve");
    for(const program::Curve_request& curve : request.curves)
      check_curve(curve);
  });
}

/// A network of an octahedron with edges of length 1.
struct Octahedral_network
{
  program::data::Triangulation triangulation;
  program::data::Network network;

  Octahedral_network()
    : triangulation(octahedron(), program::data::Unit_metric(octahedron(), program::data::Lengths(1)))
    , network(triangulation)
  {
  }
};

inline void append_checksum(std::string& text)
{
  CGAL::Flip_geodesics::internal::Fingerprint fingerprint;
  fingerprint.add(text.data(), text.size());
  text += "end " + std::to_string(fingerprint.value()) + "\n";
}

/// The bytes of a saved network as they are, if they start like one; or else what is in it between the line of the
/// input and the last line, which are put around them.
inline std::string saved_network(const std::string& bytes)
{
  namespace FG = CGAL::Flip_geodesics;
  const std::string magic = FG::internal::network_magic;
  if(bytes.compare(0, magic.size(), magic) == 0)
    return bytes;
  const Octahedral_network empty;
  std::string text = magic + " 2\ninput 6 24 " + std::to_string(FG::internal::input_fingerprint(empty.triangulation)) +
                     "\n" + bytes + "\n";
  append_checksum(text);
  return text;
}

inline void read_network(const std::string& bytes)
{
  namespace FG = CGAL::Flip_geodesics;
  Octahedral_network first, second;
  std::istringstream in(saved_network(bytes));
  try {
    FG::read_network(in, first.network);
  } catch(const FG::Error& error) {
    check_message(error.what());
    require(first.network.number_of_curves() == 0 && first.triangulation.log_position() == 0,
            "a failure leaves something");
    return;
  }
  const FG::internal::Network_validity<program::data::Network> validity(first.network); // its curves may cross
  require(validity.has_valid_chains() && first.triangulation.is_valid(), "a network that was read is not valid");
  std::stringstream written, again;
  FG::write_network(written, first.network);
  FG::read_network(written, second.network);
  FG::write_network(again, second.network);
  require(written.str() == again.str(), "a network that was read is not the one that was written");
}

using Target = void (*)(const std::string& bytes);

/// The targets by the names of the folders of their inputs.
inline const std::map<std::string, Target>& all()
{
  static const std::map<std::string, Target> targets = {
      {"off", read_off}, {"obj", read_obj},       {"ply", read_ply},        {"stl", read_stl},
      {"ts", read_ts},   {"curves", read_curves}, {"network", read_network}};
  return targets;
}

} // namespace reader_targets

#endif // FLIP_GEODESICS_TEST_READER_TARGETS_H
