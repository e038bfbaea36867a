// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes a torus with bumps, of any size, as an OFF file: a mesh to try flip_geodesics and the examples on. It uses the
// standard library alone, since all that runs on this mesh waits for it to compile.
//
//   generate_torus FILE [VERTICES_AROUND [VERTICES_ALONG]]

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>

namespace {

/*!
 * Writes a torus with bumps of `around * along` vertices and twice as many triangles. Vertex `i * along + j`, counted
 * from 0, has angle i / around around the axis and angle j / along around the tube.
 *
 * \param bumps their height, as a part of the tube's radius
 */
void write_torus(std::ostream& out, std::size_t around, std::size_t along, double bumps = 0.25)
{
  const double two_pi = 2 * std::acos(-1.0);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "OFF\n" << around * along << ' ' << 2 * around * along << " 0\n\n";
  for(std::size_t k = 0; k < around * along; ++k) {
    const double u = two_pi * static_cast<double>(k / along) / static_cast<double>(around);
    const double v = two_pi * static_cast<double>(k % along) / static_cast<double>(along);
    const double tube = 0.4 * (1 + bumps * std::cos(5 * u) * std::sin(3 * v));
    const double radius = 1 + tube * std::cos(v);
    out << radius * std::cos(u) << ' ' << radius * std::sin(u) << ' ' << tube * std::sin(v) << '\n';
  }
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < along; ++j) {
      const std::size_t next_i = (i + 1) % around, next_j = (j + 1) % along;
      const std::size_t a = i * along + j, b = next_i * along + j;
      const std::size_t c = next_i * along + next_j, d = i * along + next_j;
      out << "3  " << a << ' ' << b << ' ' << c << "\n3  " << a << ' ' << c << ' ' << d << '\n';
    }
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 2) {
    std::cerr << "generate_torus: specify the file to write\n";
    return EXIT_FAILURE;
  }
  const std::size_t around = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 400;
  const std::size_t along = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 200;
  if(around < 3 || along < 3) {
    std::cerr << "generate_torus: at least 3 vertices are required in each direction\n";
    return EXIT_FAILURE;
  }
  std::ofstream out(argv[1]);
  write_torus(out, around, along);
  out.close();
  if(!out) {
    std::cerr << "generate_torus: cannot write " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
