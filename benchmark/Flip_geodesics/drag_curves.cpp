// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Drags points of curves over a mesh, by a few edges a move: an end of a curve across it, a way point in its middle, and
// a control point of a cubic B-spline, whose curve is halved twice after each move. Writes a line for each, with a
// header; times are of one move each, in milliseconds:
//
//   mesh,triangles,what,moves,crossed,median_ms,p99_ms,max_ms,by_flips,unproven,undo_us
//
// Usage: drag_curves MOVES MESH...

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Editor = FG::Curve_editor<Triangulation>;
using FG::Input_halfedge_index;
using FG::Surface_location;

// Goes from face to face, by turns over the edge on the left and on the right, which leads on in one direction; now and
// then it turns.
class Pen
{
public:
  explicit Pen(const Triangulation& triangulation, unsigned seed)
    : m_triangulation(triangulation)
    , m_random(seed)
  {
    do
      m_halfedge = Input_halfedge_index(
          static_cast<FG::Index>(m_random() % static_cast<unsigned>(triangulation.number_of_halfedges())));
    while(triangulation.input().is_border(m_halfedge));
  }

  Surface_location move(int faces)
  {
    const auto& input = m_triangulation.input();
    for(int i = 0; i < faces; ++i) {
      m_is_left = m_random() % 16 == 0 ? m_is_left : !m_is_left;
      const Input_halfedge_index right = input.next(m_halfedge), left = input.next(right);
      Input_halfedge_index entered = FG::internal::twin_index(m_is_left ? left : right);
      if(input.is_border(entered))
        entered = FG::internal::twin_index(m_is_left ? right : left);
      m_halfedge = input.is_border(entered) ? m_halfedge : entered;
    }
    return place();
  }

  Surface_location place()
  {
    std::uniform_real_distribution<double> weight(0.1, 1);
    return {m_halfedge, {{weight(m_random), weight(m_random), weight(m_random)}}};
  }

private:
  const Triangulation& m_triangulation;
  std::mt19937 m_random;
  Input_halfedge_index m_halfedge;
  bool m_is_left = false;
};

template <class Action>
void drag(const std::string& name, Triangulation& triangulation, const std::string& what, std::size_t moves,
          std::size_t points, std::size_t dragged, const Action& after_move)
{
  constexpr int faces_per_move = 6; // about three edges
  std::vector<Pen> pens;
  std::vector<Surface_location> places;
  for(std::size_t i = 0; i < points; ++i) {
    pens.emplace_back(triangulation, static_cast<unsigned>(i + 1));
    places.push_back(pens.back().place());
  }
  Editor editor(triangulation, places);
  std::vector<double> times;
  std::size_t crossed = 0, by_flips = 0, unproven = 0;
  for(std::size_t i = 0; i < moves; ++i) {
    const Surface_location to = pens[dragged].move(faces_per_move);
    FG::Move_report report;
    times.push_back(1e3 * seconds([&] {
                      report = editor.move(dragged, to);
                      after_move(editor);
                    }));
    by_flips += report.legs_by_flips;
    unproven += report.verdict == FG::Verdict::PROVEN ? 0 : 1;
    crossed += editor.leg(dragged == 0 ? 0 : dragged - 1).size();
  }
  const double undo = seconds([&] {
    while(editor.undo()) {
    }
  });
  std::sort(times.begin(), times.end());
  std::cout << name << ',' << what << ',' << moves << ',' << crossed / moves << ',' << times[moves / 2] << ','
            << times[moves * 99 / 100] << ',' << times.back() << ',' << by_flips << ',' << unproven << ','
            << 1e6 * undo / static_cast<double>(moves) << '\n';
}

void measure(const std::string& name, std::size_t moves)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  Triangulation triangulation(mesh);
  const std::string label = benchmark_meshes::short_name(name) + ',' + std::to_string(mesh.number_of_faces());
  const auto nothing = [](const Editor&) {};
  drag(label, triangulation, "end", moves, 2, 1, nothing);
  drag(label, triangulation, "way_point", moves, 3, 1, nothing);
  drag(label, triangulation, "control_point", moves, 5, 2, nothing);
  drag(label, triangulation, "spline", (std::min)(moves, std::size_t(20)), 5, 2, [&](const Editor& editor) {
    FG::Geodesic_spline<Triangulation> spline(triangulation, editor.legs(), FG::Spline_kind::CUBIC_B_SPLINE);
    spline.refine(0, 2);
    spline.finish();
  });
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 3 || std::stoul(argv[1]) == 0)
      throw std::invalid_argument("usage: drag_curves MOVES MESH...");
    std::cout << "mesh,triangles,what,moves,crossed,median_ms,p99_ms,max_ms,by_flips,unproven,undo_us\n";
    for(int i = 2; i < argc; ++i)
      measure(argv[i], std::stoul(argv[1]));
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
