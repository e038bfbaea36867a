// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_DATA_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_DATA_INPUT_H

#include "input/curve_input.h"
#include "input/read_obj.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Networks that are not given as curves but follow from other data: segmentations and textures.
namespace program {

/// The label of each face of the file: one a line, in the order of the faces. \throws Bad_input
inline std::vector<long long> read_labels(const Input_mesh& mesh, const Input_text& input)
{
  std::vector<long long> labels;
  Text_scanner words(input, '#');
  for(std::string_view word; !(word = words.next_word_of_text()).empty();) {
    labels.push_back(0);
    if(const char* const error = parse_number(word, labels.back()))
      words.fail("label " + std::to_string(labels.size() - 1) + ", '" + printable(word) + "', " + error +
                 "; write one label per line");
  }
  if(labels.size() != mesh.number_of_faces_in_file())
    throw Bad_input(input.name() + ": the file has " + counted(labels.size(), "label", "labels") + " for " +
                    counted(mesh.number_of_faces_in_file(), "face", "faces") + "; write one label for each face");
  return labels;
}

/// The texture coordinates of the corners of the faces of an OBJ file, in the order of the file.
class Texture_corners
{
public:
  using Coordinates = std::array<double, 3>;

  /// \throws Bad_input
  explicit Texture_corners(const Input_text& input)
    : m_name(input.name())
  {
    if(input.format() != "obj")
      throw Bad_input(input.name() + ": seams require the texture coordinates of an .obj file; use such a file");
    m_soup = read_obj(input, &m_texture);
    if(m_texture.coordinates.empty())
      throw Bad_input(input.name() + ": the file has no texture coordinates (lines vt); use a textured mesh");
  }

  std::size_t number_of_faces() const { return m_soup.faces.size(); }

  /// The coordinates of a face of the mesh at one of its vertices.
  const Coordinates& at(const Input_mesh& mesh, Mesh::Face_index mesh_face, Mesh::Vertex_index v) const
  {
    const std::size_t f = mesh.face_in_file(mesh_face);
    const std::vector<std::size_t>& face = m_soup.faces[f];
    const auto is_at_v = [&](std::size_t point) { return mesh.comes_from(v, point); };
    const auto corner = static_cast<std::size_t>(std::find_if(face.begin(), face.end(), is_at_v) - face.begin());
    if(corner == face.size())
      throw Bad_input(
          m_name + ": face " + std::to_string(f) +
          " does not have the same vertices in the mesh and in the texture; write the file again with lines "
          "v, vt and f only");
    return m_texture.coordinates[m_texture.corners[f][corner]];
  }

private:
  std::string m_name;
  Soup m_soup;
  Texture m_texture;
};

namespace data {

// Which edges the curves run along is a matter of connectivity alone, whatever the lengths.
using Lengths = boost::static_property_map<double, Mesh::Edge_index>;
using Unit_metric = CGAL::Flip_geodesics::Edge_length_metric<Mesh, Lengths>;
using Triangulation =
    CGAL::Flip_geodesics::Intrinsic_triangulation<Mesh, CGAL::Flip_geodesics::Intrinsic_triangulation_traits<Kernel>,
                                                  Unit_metric>;
using Network = CGAL::Flip_geodesics::Edge_path_network<Triangulation>;

// The curves of a network as requests.
inline Network_request requests(const Network& network, const std::string& name)
{
  namespace FG = CGAL::Flip_geodesics;
  Network_request request;
  for(FG::Curve_index c : network.curves()) {
    Curve_request curve;
    curve.name = name + ", curve " + std::to_string(c.idx());
    curve.is_closed = network.is_closed(c);
    FG::Halfedge_index last;
    for(FG::Halfedge_index h : network.halfedges(c)) {
      curve.vertices.push_back(network.triangulation().tail(h));
      last = h;
    }
    if(!curve.is_closed)
      curve.vertices.push_back(network.triangulation().head(last));
    request.curves.push_back(curve);
  }
  return request;
}

} // namespace data

/// The boundaries between faces with different labels. \throws Bad_input
inline Network_request read_segmentation(const Input_mesh& input_mesh, const Input_text& input, bool has_free_junctions)
{
  namespace FG = CGAL::Flip_geodesics;
  const Mesh& mesh = input_mesh;
  const std::vector<long long> labels = read_labels(input_mesh, input);
  const auto label = [&](Mesh::Face_index f) { return labels[input_mesh.face_in_file(f)]; };
  data::Triangulation triangulation(mesh, data::Unit_metric(mesh, data::Lengths(1)));
  data::Network network(triangulation);
  try {
    FG::add_region_boundaries(network, mesh, boost::make_function_property_map<Mesh::Face_index>(label),
                              has_free_junctions ? FG::Junctions::FREE : FG::Junctions::FIXED);
  } catch(const FG::Error& error) {
    throw Bad_input(input.name() + ": " + error.what() + "; repair the mesh");
  }
  if(network.number_of_curves() == 0)
    throw Bad_input(input.name() +
                    ": no edge separates faces with different labels; use at least two labels in one component");
  return data::requests(network, input.name());
}

/// The edges of an OBJ file at which texture coordinates jump. \throws Bad_input
inline Network_request read_seams(const Input_mesh& input_mesh, const Input_text& input)
{
  namespace FG = CGAL::Flip_geodesics;
  const Mesh& mesh = input_mesh;
  const Texture_corners corners(input);
  if(corners.number_of_faces() != input_mesh.number_of_faces_in_file())
    throw Bad_input(
        input.name() +
        ": the mesh and the texture have different numbers of faces; write the file again with lines v, vt and f only");
  const auto texture = [&](Mesh::Halfedge_index h) { return corners.at(input_mesh, mesh.face(h), mesh.target(h)); };
  data::Triangulation triangulation(mesh, data::Unit_metric(mesh, data::Lengths(1)));
  data::Network network(triangulation);
  try {
    FG::add_seams(network, mesh, boost::make_function_property_map<Mesh::Halfedge_index>(texture));
  } catch(const FG::Error& error) {
    throw Bad_input(input.name() + ": " + error.what() + "; repair the mesh");
  }
  if(network.number_of_curves() == 0)
    throw Bad_input(input.name() + ": the texture has no seam inside the surface; use another texture");
  return data::requests(network, input.name());
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_DATA_INPUT_H
