// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_DATA_INPUT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_DATA_INPUT_H

#include "curve_input.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Networks that are not given as curves but follow from other data: segmentations and textures.
namespace program {

/// The label of each face: one a line, in the order of the faces. \throws Bad_input
inline std::vector<long long> read_labels(const Mesh& mesh, const std::string& file)
{
  std::ifstream in(file);
  if(!in || in.peek() == std::ifstream::traits_type::eof())
    throw Bad_input(file + ": cannot be opened or is empty; check the path");
  std::vector<long long> labels;
  for(std::string word; in >> word;) {
    std::istringstream number(word);
    long long label = 0;
    if(!(number >> label) || !number.eof())
      throw Bad_input(file + ": label " + std::to_string(labels.size()) + ", '" + printable(word) +
                      "', is not a whole number; write one label per line");
    labels.push_back(label);
  }
  if(labels.size() != mesh.number_of_faces())
    throw Bad_input(file + ": there are " + std::to_string(labels.size()) + " labels for " +
                    std::to_string(mesh.number_of_faces()) + " faces; write one for each face");
  return labels;
}

/// The texture coordinates of the corners of the faces of an OBJ file, in the order of the file.
class Texture_corners
{
public:
  using Coordinates = std::array<double, 3>;

  /// \throws Bad_input
  explicit Texture_corners(const std::string& file)
    : m_file(file)
  {
    if(extension(file) != "obj")
      throw Bad_input(file + ": seams are read off the texture coordinates of an .obj file; give one");
    std::ifstream in(file);
    std::string line;
    for(std::size_t number = 0; get_obj_line(in, line, number);) {
      const std::string keyword = line.substr(0, line.find(' '));
      std::istringstream words(line.substr(keyword.size()));
      if(keyword == "v")
        ++m_number_of_vertices;
      else if(keyword == "vt")
        read_coordinates(words, number);
      else if(keyword == "f")
        read_face(words, number);
    }
    if(m_coordinates.empty())
      throw Bad_input(file + ": there are no texture coordinates, lines vt, in it; give a textured mesh");
  }

  std::size_t number_of_faces() const { return m_faces.size(); }

  /// The coordinates of face `f` at vertex `v`.
  const Coordinates& at(std::size_t f, std::size_t v) const
  {
    for(const Corner& corner : m_faces[f])
      if(corner.vertex == v)
        return m_coordinates[corner.texture];
    throw Bad_input(m_file + ": face " + std::to_string(f) + " was read differently by the mesh reader; simplify it");
  }

private:
  struct Corner
  {
    std::size_t vertex, texture;
  };

  [[noreturn]] void fail(std::size_t number, const std::string& what) const
  {
    throw Bad_input(m_file + ": line " + std::to_string(number) + ' ' + what);
  }

  void read_coordinates(std::istringstream& words, std::size_t number)
  {
    Coordinates c = {0, 0, 0};
    std::size_t count = 0;
    for(double x = 0; count < 3 && words >> x; ++count)
      c[count] = x;
    if(count == 0)
      fail(number, "has no texture coordinate; correct it");
    m_coordinates.push_back(c);
  }

  // An index of an OBJ file, from 1 or backward from -1.
  static bool resolve(const std::string& text, std::size_t count, std::size_t& index)
  {
    std::istringstream in(text);
    long long i = 0;
    if(!(in >> i) || !in.eof())
      return false;
    i = i < 0 ? static_cast<long long>(count) + i : i - 1;
    index = static_cast<std::size_t>(i);
    return i >= 0 && i < static_cast<long long>(count);
  }

  void read_face(std::istringstream& words, std::size_t number)
  {
    m_faces.emplace_back();
    for(std::string word; words >> word;) {
      const std::size_t slash = word.find('/');
      const std::string vertex = word.substr(0, slash);
      const std::string rest = slash == std::string::npos ? "" : word.substr(slash + 1);
      Corner corner = {0, 0};
      if(!resolve(vertex, m_number_of_vertices, corner.vertex))
        fail(number, "has a vertex that does not exist; correct it");
      if(!resolve(rest.substr(0, rest.find('/')), m_coordinates.size(), corner.texture))
        fail(number, "has a corner without a valid texture coordinate; texture all faces");
      m_faces.back().push_back(corner);
    }
  }

  std::string m_file;
  std::size_t m_number_of_vertices = 0;
  std::vector<Coordinates> m_coordinates;
  std::vector<std::vector<Corner>> m_faces;
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
  Network_request request;
  for(Index c = 0; c < network.number_of_curves(); ++c) {
    Curve_request curve;
    curve.name = name + ", curve " + std::to_string(c);
    curve.is_closed = network.is_closed(c);
    Index last = CGAL::Flip_geodesics::null_index;
    for(Index h : network.halfedges(c)) {
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
inline Network_request read_segmentation(const Mesh& mesh, const std::string& file, bool has_free_junctions)
{
  namespace FG = CGAL::Flip_geodesics;
  const std::vector<long long> labels = read_labels(mesh, file);
  const auto label = [&](Mesh::Face_index f) { return labels[static_cast<std::size_t>(f)]; };
  data::Triangulation triangulation(mesh, data::Unit_metric(mesh, data::Lengths(1)));
  data::Network network(triangulation);
  try {
    FG::add_region_boundaries(network, mesh, boost::make_function_property_map<Mesh::Face_index>(label),
                              has_free_junctions ? FG::Junctions::FREE : FG::Junctions::FIXED);
  } catch(const FG::Error& error) {
    throw Bad_input(file + ": " + error.what() + "; repair the mesh");
  }
  if(network.number_of_curves() == 0)
    throw Bad_input(file + ": all faces have one label, so that there is no boundary; use at least two labels");
  return data::requests(network, file);
}

/// The edges of an OBJ file at which texture coordinates jump. \throws Bad_input
inline Network_request read_seams(const Mesh& mesh, const std::string& file)
{
  namespace FG = CGAL::Flip_geodesics;
  const Texture_corners corners(file);
  if(corners.number_of_faces() != mesh.number_of_faces())
    throw Bad_input(file + ": the mesh reader found other faces than the texture reader; simplify the file");
  const auto texture = [&](Mesh::Halfedge_index h) {
    return corners.at(static_cast<std::size_t>(mesh.face(h)), static_cast<std::size_t>(mesh.target(h)));
  };
  data::Triangulation triangulation(mesh, data::Unit_metric(mesh, data::Lengths(1)));
  data::Network network(triangulation);
  try {
    FG::add_seams(network, mesh, boost::make_function_property_map<Mesh::Halfedge_index>(texture));
  } catch(const FG::Error& error) {
    throw Bad_input(file + ": " + error.what() + "; repair the mesh");
  }
  if(network.number_of_curves() == 0)
    throw Bad_input(file + ": the texture has no seam inside the surface; there is nothing to straighten");
  return data::requests(network, file);
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_DATA_INPUT_H
