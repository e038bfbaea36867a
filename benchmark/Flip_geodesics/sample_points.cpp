// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Draws random points of a mesh, for --points and --bezier of flip_geodesics: a line per curve, of points at vertices,
// on edges and inside faces of one component. Every other curve stays in a small part of the mesh. Shares no code with
// the library.
//
// Exit status: 0, or 2 on bad input.

#include "checker_mesh.h"
#include "checker_mesh_io.h"

#include <CLI/CLI.hpp>

#include <array>
#include <exception>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace checker = polyline_checker;
using checker::Index;
using checker::Mesh;

namespace {

class Source
{
public:
  Source(const Mesh& mesh, unsigned seed)
    : m_mesh(mesh)
    , m_random(seed)
  {
  }

  Index below(std::size_t bound) { return Index(m_random() % bound); }

  /// Faces of one component, the next at most so many steps from the one before.
  std::vector<Index> faces(std::size_t count, std::size_t most_steps)
  {
    std::vector<Index> result = {below(m_mesh.number_of_faces())};
    while(result.size() < count) {
      Index face = result.back();
      for(std::size_t step = below(most_steps) + 1; step > 0; --step) {
        const Index twin = m_mesh.twin(3 * face + below(3));
        face = twin == checker::null_index ? face : twin / 3;
      }
      result.push_back(face);
    }
    return result;
  }

  /// A point of the face, as `v`, `a,b,t` or `a,b,c,t,u`; sometimes close to a corner or to an edge.
  std::string point(Index face)
  {
    const Index corner = 3 * face + below(3);
    const std::string a = std::to_string(m_mesh.vertex(corner)), b = std::to_string(m_mesh.vertex(Mesh::next(corner))),
                      c = std::to_string(m_mesh.vertex(Mesh::previous(corner)));
    std::array<double, 3> weights;
    for(double& weight : weights)
      weight = below(8) == 0 ? 1e-6 * part() : part();
    const double sum = weights[0] + weights[1] + weights[2];
    switch(below(4)) {
    case 0:
      return a;
    case 1:
      return a + ',' + b + ',' + text(weights[1] / (weights[0] + weights[1]));
    default:
      return a + ',' + b + ',' + c + ',' + text(weights[1] / sum) + ',' + text(weights[2] / sum);
    }
  }

private:
  double part() { return (1 + double(m_random() % 1000000)) / 1000001; }

  static std::string text(double x)
  {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << x;
    return out.str();
  }

  const Mesh& m_mesh;
  std::mt19937 m_random;
};

// The marks of the splines: nothing for a Bezier curve, B-splines and closed ones.
void write_curves(const Mesh& mesh, std::size_t count, unsigned seed, bool are_splines)
{
  Source source(mesh, seed);
  const std::array<std::string, 3> marks = {"", "s ", "o "};
  for(std::size_t i = 0; i < count; ++i) {
    const std::size_t number = are_splines ? 3 + source.below(3) : 2 + source.below(3);
    const std::size_t most_steps = i % 2 == 0 ? 20 : 20 + mesh.number_of_faces() / 4;
    std::set<std::string> known; // twice the same point is an error, in neighbors
    std::string line = are_splines ? marks[i % marks.size()] : "";
    for(Index face : source.faces(number, (std::min)(most_steps, std::size_t(2000)))) {
      std::string point = source.point(face);
      for(int tries = 0; !known.insert(point).second && tries < 100; ++tries)
        point = source.point(face);
      line += point + ' ';
    }
    std::cout << line << '\n';
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::string file;
  std::size_t count = 10;
  unsigned seed = 1;
  bool are_splines = false;
  CLI::App app("Random points of a triangle mesh", "sample_points");
  app.add_option("mesh", file, "The mesh: OFF, OBJ, PLY or STL")->required();
  app.add_option("--curves", count, "Number of lines")->capture_default_str();
  app.add_option("--seed", seed, "Seed of the random choices")->capture_default_str();
  app.add_flag("--splines", are_splines,
               "Write control points of Bezier curves, open B-splines and closed B-splines in turn");
  try {
    app.parse(argc, argv);
    write_curves(checker::read_mesh(file), count, seed, are_splines);
    return std::cout.flush() ? 0 : 2;
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch(const std::exception& error) {
    std::cerr << "sample_points: " << file << ": " << error.what() << '\n';
    return 2;
  }
}
