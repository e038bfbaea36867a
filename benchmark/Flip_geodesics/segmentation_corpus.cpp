// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Straightens the boundaries of segmentations and checks that the patches keep their topology.
//
//   segmentation_corpus FOLDER TABLE [RATIO]
//
// TABLE has a header and lines `segmentation mesh ...` between tabs, files in FOLDER. For each, and for fixed and free
// junctions, a line is written: the stop is at RATIO (default 0.9) of each curve's length, or at the end for RATIO 0.

#include "../../test/Flip_geodesics/Topological_signature.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Flip_geodesics_test::Curve_system;
using Flip_geodesics_test::Topological_signature;

namespace {

std::vector<int> read_labels(const std::string& file)
{
  std::ifstream in(file);
  std::vector<int> labels;
  for(int label = 0; in >> label;)
    labels.push_back(label);
  return labels;
}

std::string straighten(const Mesh& mesh, const std::vector<int>& labels, FG::Junctions junctions, double ratio)
{
  using Clock = std::chrono::steady_clock;
  Triangulation triangulation(mesh);
  Network network(triangulation);
  const auto start = Clock::now();
  const auto regions = boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
  FG::add_region_boundaries(network, mesh, regions, junctions);
  const auto built = Clock::now();
  const Curve_system before(network);
  const auto ready = Clock::now();
  const FG::Shortening_report report =
      ratio > 0 ? FG::shorten(network, CGAL::parameters::stop_predicate(FG::Curve_length_ratio_stop_predicate(ratio)))
                : FG::shorten(network);
  const auto finished = Clock::now();

  std::map<std::string, int> counts;
  std::set<int> contracted;
  double initial_length = 0, length = 0;
  for(std::size_t c = 0; c < report.curves.size(); ++c) {
    const FG::Curve_report& curve = report.curves[c];
    ++counts[FG::to_string(curve.status)];
    initial_length += curve.initial_length;
    length += curve.length;
    if(curve.status == FG::Shortening_status::CONTRACTED)
      contracted.insert(static_cast<int>(c));
  }
  const bool is_same =
      Topological_signature(before, contracted) == Topological_signature(Curve_system(network), contracted);
  std::ostringstream out;
  out << report.curves.size() << ' ' << (is_same && network.is_valid() ? "same" : "CHANGED") << ' '
      << length / initial_length << ' ' << report.flips << ' '
      << std::chrono::duration<double, std::milli>(built - start).count() << ' '
      << std::chrono::duration<double, std::milli>(finished - ready).count();
  for(const auto& [status, count] : counts)
    out << ' ' << status << '=' << count;
  return out.str();
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 3) {
    std::cerr << "usage: segmentation_corpus FOLDER TABLE [RATIO]\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];
  const double ratio = argc > 3 ? std::atof(argv[3]) : 0.9;
  std::ifstream table(argv[2]);
  std::string line;
  std::getline(table, line);
  std::cout << "segmentation junctions curves topology length_ratio flips build_ms shorten_ms statuses\n";
  bool is_good = true;
  while(std::getline(table, line)) {
    std::istringstream words(line);
    std::string segmentation, file;
    words >> segmentation >> file;
    Mesh mesh;
    const std::vector<int> labels = read_labels(folder + '/' + segmentation);
    if(!CGAL::IO::read_polygon_mesh(folder + '/' + file, mesh) || labels.size() != mesh.number_of_faces()) {
      std::cout << segmentation << " cannot be read\n";
      is_good = false;
      continue;
    }
    for(FG::Junctions junctions : {FG::Junctions::FIXED, FG::Junctions::FREE}) {
      std::string result;
      try {
        result = straighten(mesh, labels, junctions, ratio);
      } catch(const FG::Error& error) {
        result = std::string("ERROR ") + error.what();
      }
      is_good = is_good && result.find("CHANGED") == std::string::npos;
      std::cout << segmentation << (junctions == FG::Junctions::FIXED ? " fixed " : " free ") << result << std::endl;
    }
  }
  return is_good && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
