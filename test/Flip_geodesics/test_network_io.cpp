// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE network_io

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Curve_index;
using FG::Edge_index;
using FG::Halfedge_index;
using FG::Index;
using FG::Segment_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

using Certified_setting = Basic_curve_setting<
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>>;

namespace {

// Everything that a network and its triangulation are: connectivity, bits of vectors, words, curves, stacks, the log.
template <class Setting>
std::string description(const Setting& setting)
{
  std::ostringstream out;
  out << std::hexfloat;
  const auto& t = setting.triangulation;
  for(Halfedge_index h : descriptors<Halfedge_index>(t.number_of_halfedges())) {
    out << h << ':' << t.tail(h);
    if(!t.is_border(h))
      out << ' ' << t.next(h) << ' ' << t.geometry(h).x << ' ' << t.geometry(h).y;
    out << ' ' << t.version(t.edge(h)) << ' ' << t.crossings(t.edge(h));
    const FG::Edge_sequence word = t.edge_sequence(h);
    out << " [" << word.along;
    for(FG::Input_halfedge_index letter : word.crossed)
      out << ' ' << letter;
    out << "]\n";
  }
  const auto& n = setting.network;
  for(Curve_index c : descriptors<Curve_index>(n.number_of_curves())) {
    out << "curve " << n.is_closed(c) << ' ' << n.initial_length(c);
    n.for_each_segment(c, [&](Segment_index s) { out << ' ' << s << '@' << n.halfedge(s) << n.is_head_fixed(s); });
    out << '\n';
  }
  for(Edge_index e : descriptors<Edge_index>(t.number_of_edges()))
    for(Segment_index s : n.bundle(e))
      out << e << '/' << s << ' ';
  out << n.end_of_segment_ids() << '\n';
  for(Halfedge_index h : setting.flips())
    out << h << ' ';
  return out.str();
}

template <class Setting>
std::string saved(const Setting& setting)
{
  std::ostringstream out;
  FG::write_network(out, setting.network);
  return out.str();
}

// What is derived from the curves: their certificates and polylines, or the errors instead.
template <class Setting>
std::string derived(const Setting& setting)
{
  std::ostringstream out;
  out << std::hexfloat;
  const auto& n = setting.network;
  try {
    for(const FG::Curve_certificate& certificate : FG::certify(n).curves)
      out << FG::to_string(certificate.verdict()) << ' ' << certificate.segment << '\n';
    FG::Curve_extractor<typename Setting::Network> extractor(n);
    for(Curve_index c : descriptors<Curve_index>(n.number_of_curves())) {
      std::vector<Surface::Point> points;
      extractor.points(c, std::back_inserter(points));
      for(const Surface::Point& p : points)
        out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
  } catch(const FG::Error& error) {
    out << error.what();
  }
  return out.str();
}

// Loads what was saved: nothing differs, and it is saved as the same bytes.
template <class Setting>
void check_loaded(Setting& loaded, const Setting& original)
{
  const std::string text = saved(original);
  std::istringstream in(text);
  FG::read_network(in, loaded.network);
  BOOST_TEST(loaded.network.is_valid() == original.network.is_valid());
  BOOST_TEST(loaded.triangulation.is_valid());
  BOOST_TEST((description(loaded) == description(original)));
  BOOST_TEST((derived(loaded) == derived(original)));
  BOOST_TEST((saved(loaded) == text));
}

// Saved, loaded and gone on with, nothing differs from the network that was not saved.
template <class Setting>
void check_round_trip(Setting& original, const Mesh_soup& soup)
{
  Setting loaded(soup);
  check_loaded(loaded, original);
  BOOST_TEST(loaded.network.is_valid());
  original.pull();
  loaded.pull();
  BOOST_TEST((description(loaded) == description(original)));
  original.network.clear();
  loaded.network.clear();
  original.triangulation.rollback();
  loaded.triangulation.rollback();
  BOOST_TEST((description(loaded) == description(original)));
}

template <class Setting>
void add_curves(Setting& setting)
{
  auto regions = setting.mesh.template add_property_map<Surface::Face_index, int>("f:region", 0).first;
  for(const auto f : setting.mesh.faces()) {
    const auto& p = setting.mesh.point(setting.mesh.target(setting.mesh.halfedge(f)));
    regions[f] = (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0) + (p.z() > 0.1 ? 4 : 0);
  }
  FG::add_region_boundaries(setting.network, setting.mesh, regions, FG::Junctions::FREE);
}

template <class Setting>
void check_stopped_at(const Mesh_soup& soup, double ratio)
{
  Setting setting(soup);
  add_curves(setting);
  setting.pull(FG::Length_ratio_stop_predicate(ratio));
  check_round_trip(setting, soup);
}

// A text whose checksum is right, whatever is in it.
std::string with_checksum(std::string text)
{
  text.resize(text.rfind("end "));
  FG::internal::Fingerprint fingerprint;
  fingerprint.add(text.data(), text.size());
  return text + "end " + std::to_string(fingerprint.value()) + "\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t position = text.find(from);
  BOOST_REQUIRE(position != std::string::npos);
  return text.replace(position, from.size(), to);
}

template <class Exception, class Setting = Curve_setting>
void check_throws(const Mesh_soup& soup, const std::string& text)
{
  Setting setting(soup);
  std::istringstream in(text);
  BOOST_CHECK_THROW(FG::read_network(in, setting.network), Exception);
  BOOST_TEST(setting.network.number_of_curves() == 0);
  BOOST_TEST(setting.triangulation.log_position() == 0u);
  add_curves(setting); // is usable as if nothing had been tried
  BOOST_TEST(setting.network.is_valid());
}

} // namespace

BOOST_AUTO_TEST_CASE(round_trips)
{
  for(const Mesh_soup& soup : {bumpy_sphere(6, 0.3, 1), torus(16, 8, 2, 0.8), cube(3)})
    for(double ratio : {1.0, 0.97, 0.9, 0.0}) {
      check_stopped_at<Curve_setting>(soup, ratio);
      check_stopped_at<Certified_setting>(soup, ratio);
    }
}

BOOST_AUTO_TEST_CASE(paths_with_fixed_nodes_and_contracted_loops)
{
  const Mesh_soup soup = bumpy_sphere(6, 0.2, 2);
  Curve_setting setting(soup);
  setting.add_path_through({3_v, 60_v, 100_v});
  setting.network.fix_nodes_at(60_v);
  Curve_setting::Search search(setting.triangulation);
  const std::vector<Halfedge_index> outgoing_halfedge = search(3_v, 60_v);
  const Halfedge_index h = outgoing_halfedge.front();
  setting.network.add_curve(std::vector<Halfedge_index>{h, setting.triangulation.twin(h)},
                            CGAL::parameters::is_closed(true)); // to and fro
  FG::order_overlapping_curves(setting.network);
  setting.pull();
  check_round_trip(setting, soup);
}

BOOST_AUTO_TEST_CASE(inserted_vertices)
{
  const Mesh_soup soup = bumpy_sphere(6, 0.2, 3);
  Curve_setting setting(soup);
  setting.add_path(0_v, 90_v);
  setting.pull();
  setting.network.clear();
  Random_numbers random(5);
  for(int i = 0; i < 20; ++i)
    setting.triangulation.insert(
        {FG::Input_halfedge_index(2 * random.below(setting.triangulation.input().number_of_halfedges() / 2)),
         {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}});
  const Vertex_index last(setting.triangulation.number_of_vertices() - 1);
  setting.network.add_curve(std::vector<Halfedge_index>{setting.triangulation.outgoing(last)});
  check_round_trip(setting, soup);
}

namespace {

// Surfaces with few large faces, with rounded coordinates as scans have them, with a border, and with a handle.
std::vector<Mesh_soup> surfaces_to_refine()
{
  return {box(1, 2, 3, 1), bumpy_sphere(5, 0.3, 7), jittered_grid(6, 5, Diagonal_rule::RISING, 0.2, 3),
          torus(12, 6, 2, 0.8)};
}

// Paths between random vertices, every other one twice, and walks to and fro and around.
template <class Setting>
void add_random_curves(Setting& setting, Random_numbers& random)
{
  for(int i = 0; i < 4; ++i) {
    const int n = static_cast<int>(setting.triangulation.input().number_of_vertices());
    const Vertex_index source(random.below(n)), target((source.idx() + 1 + random.below(n - 1)) % n);
    for(int copies = 0; copies <= i % 2; ++copies)
      setting.add_path(source, target);
  }
  setting.network.add_curve(random_walk(setting.triangulation, 5, false, random));
  const std::vector<Halfedge_index> loop = random_walk(setting.triangulation, 6, true, random);
  if(!loop.empty())
    setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
}

template <class Setting>
void divide_first_segments(Setting& setting, Random_numbers& random)
{
  for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
    if(!setting.network.is_contracted(c)) {
      const FG::Halfedge_index h = setting.network.halfedge(setting.network.first_segment(c));
      const auto point = FG::internal::point_on_edge(setting.triangulation, h, random.uniform(0.2, 0.8));
      setting.network.split_edge(h, point->location, point->gap);
    }
}

template <class Setting>
void insert_random_points(Setting& setting, Random_numbers& random)
{
  const auto& input = setting.triangulation.input();
  for(int i = 0; i < 6; ++i) {
    const FG::Input_halfedge_index h(random.below(input.number_of_halfedges()));
    if(!input.is_border(h)) // every other point on an edge
      setting.network.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), i % 2 * random.uniform(0.1, 1)}}});
  }
}

std::size_t count_lines(const std::string& text, const std::string& start)
{
  std::size_t count = 0;
  for(std::size_t i = text.find("\n" + start); i != std::string::npos; i = text.find("\n" + start, i + 1))
    ++count;
  return count;
}

// Networks that were refined, with points of their own on curves, on the border and elsewhere. Returns how many points
// were inserted on edges.
template <class Setting>
std::size_t check_refined_networks(const Mesh_soup& soup, unsigned seed)
{
  Random_numbers random(seed);
  Setting setting(soup);
  add_random_curves(setting, random);
  try {
    FG::order_overlapping_curves(setting.network);
  } catch(const FG::Crossing_curves_error&) {
    setting.network.clear(); // as most do
    for(int i = 0; i < 2; ++i)
      setting.add_path(0_v, Vertex_index(setting.triangulation.number_of_vertices() - 1));
  }
  if(seed % 2 == 0)
    setting.pull();
  if(seed % 3 == 0)
    divide_first_segments(setting, random);
  if(seed % 3 == 1)
    insert_random_points(setting, random);
  FG::Refinement_options options;
  options.maximum_insertions = 40;
  FG::refine(setting.network, options);
  const std::size_t on_edges = count_lines(saved(setting), "e ");
  check_round_trip(setting, soup);
  return on_edges;
}

} // namespace

BOOST_AUTO_TEST_CASE(refined_networks)
{
  std::size_t on_edges = 0;
  for(const Mesh_soup& soup : surfaces_to_refine())
    for(unsigned seed = 1; seed <= 12; ++seed) {
      on_edges += check_refined_networks<Curve_setting>(soup, seed);
      on_edges += check_refined_networks<Certified_setting>(soup, seed);
    }
  BOOST_TEST(on_edges > 200u);
}

// All pairs of vertices of a box: rounded points on the curves' edges, beside the edges by their weights.
BOOST_AUTO_TEST_CASE(refined_paths_of_a_box)
{
  const Mesh_soup soup = box(1, 2, 3, 1);
  for(Index source = 0; source < 8; ++source)
    for(Index target = 0; target < 8; ++target) {
      if(source == target)
        continue;
      Curve_setting setting(soup);
      setting.add_path(Vertex_index(source), Vertex_index(target));
      setting.pull();
      FG::Refinement_options options;
      options.maximum_insertions = 50;
      FG::refine(setting.network, options);
      check_round_trip(setting, soup);
    }
}

// The order in which curves lie on an edge is restored before it is found as well.
BOOST_AUTO_TEST_CASE(overlapping_curves_before_and_after_they_are_ordered)
{
  int crossing = 0;
  for(const Mesh_soup& soup : surfaces_to_refine())
    for(unsigned seed = 1; seed <= 12; ++seed) {
      Random_numbers random(seed);
      Certified_setting setting(soup), loaded(soup);
      add_random_curves(setting, random);
      crossing += setting.network.is_valid() ? 0 : 1;
      check_loaded(loaded, setting);
      std::string errors[2];
      for(Certified_setting* s : {&setting, &loaded})
        try {
          FG::order_overlapping_curves(s->network);
        } catch(const FG::Crossing_curves_error& error) {
          errors[s == &setting ? 0 : 1] = error.what();
        }
      BOOST_TEST(errors[0] == errors[1]);
      BOOST_TEST((description(loaded) == description(setting)));
      Certified_setting again(soup);
      check_loaded(again, setting);
    }
  BOOST_TEST(crossing > 10);
}

BOOST_AUTO_TEST_CASE(an_empty_network)
{
  Curve_setting setting(sphere(3));
  check_round_trip(setting, sphere(3));
}

// Networks one after the other come back one after the other, what is behind them stays, and a carriage return at the
// end of each line does no harm.
BOOST_AUTO_TEST_CASE(several_in_one_stream)
{
  const Mesh_soup soup = torus(16, 8, 2, 0.8);
  Curve_setting first(soup), second(soup);
  add_curves(first);
  second.add_path(0_v, 60_v);
  second.pull();
  std::string text = saved(first) + saved(second) + "and more\n";
  for(int round = 0; round < 2; ++round) {
    std::istringstream in(text);
    in.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    Curve_setting one(soup), other(soup);
    FG::read_network(in, one.network);
    FG::read_network(in, other.network);
    BOOST_TEST((saved(one) == saved(first)));
    BOOST_TEST((saved(other) == saved(second)));
    std::string rest;
    BOOST_TEST((in >> rest && rest == "and"));
    text = std::regex_replace(text, std::regex("\n"), "\r\n");
  }
}

BOOST_AUTO_TEST_CASE(a_stream_that_has_failed)
{
  Curve_setting setting(cube(2));
  std::istringstream in(saved(setting));
  in.setstate(std::ios::failbit);
  BOOST_CHECK_EXCEPTION(FG::read_network(in, setting.network), FG::File_format_error, [](const FG::Error& error) {
    return std::string(error.what()).find("nothing can be read") != std::string::npos;
  });
}

// Any change of any character is noticed.
BOOST_AUTO_TEST_CASE(damaged_text)
{
  const Mesh_soup soup = torus(16, 8, 2, 0.8);
  Curve_setting setting(soup);
  add_curves(setting);
  setting.pull(FG::Length_ratio_stop_predicate(0.85));
  const std::string text = saved(setting);
  Random_numbers random(1);
  for(int i = 0; i < 200; ++i) {
    std::string damaged = text;
    char& c = damaged[static_cast<std::size_t>(random.below(static_cast<int>(text.size()) - 1))];
    c = c == '7' ? '3' : '7';
    check_throws<FG::File_format_error>(soup, damaged);
  }
  for(std::size_t length : {std::size_t(0), std::size_t(5), text.size() / 2, text.size() - 25})
    check_throws<FG::File_format_error>(soup, text.substr(0, length));
  check_throws<FG::File_format_error>(soup, "OFF\n3 1 0\n");
  check_throws<FG::File_format_error>(soup, replaced(text, "network 2\n", "network 3\n"));
}

// What has a right checksum may still be wrong, and must neither crash nor be believed.
BOOST_AUTO_TEST_CASE(forged_text)
{
  const Mesh_soup soup = torus(16, 8, 2, 0.8);
  Curve_setting setting(soup);
  add_curves(setting);
  setting.pull(FG::Length_ratio_stop_predicate(0.85));
  const std::string text = saved(setting);
  const auto refused = [&](const std::string& from, const std::string& to) {
    check_throws<FG::File_format_error>(soup, with_checksum(replaced(text, from, to)));
  };
  refused("\nf ", "\nf 1000000");
  refused("\nf ", "\nf -");
  refused("\nf ", "\nx ");
  refused("\nf ", "\nr ");
  refused("log ", "log 99999999");
  refused("log ", "log -");
  refused("curves ", "curves 9");
  refused("closed ", "ajar ");
  refused("closed ", "closed nothing ");
  refused("stacks ", "stacks 77");
  const std::size_t curve = text.find("closed ");
  const std::size_t line = text.find('\n', curve) + 1, blank = text.find(' ', line);
  for(const char* id : {"0", "-4", "999999999", "12345678901234567890"})
    check_throws<FG::File_format_error>(soup, with_checksum(text.substr(0, line) + id + text.substr(blank)));
  for(const char* halfedge : {" -1", " 999999", " 0", " 1"}) // or not connected
    check_throws<FG::File_format_error>(
        soup, with_checksum(text.substr(0, blank) + halfedge + text.substr(text.find(' ', blank + 1))));
}

namespace {

// The lines of a text's flip log, and the text with other ones.
std::vector<std::string> log_lines(const std::string& text)
{
  std::istringstream in(text.substr(text.find("log ") + 4));
  std::size_t size = 0;
  in >> size;
  std::vector<std::string> lines(size);
  std::string line;
  std::getline(in, line);
  for(std::string& entry : lines)
    std::getline(in, entry);
  return lines;
}

std::string with_log(const std::string& text, const std::vector<std::string>& lines)
{
  std::string log = "log " + std::to_string(lines.size()) + "\n";
  for(const std::string& line : lines)
    log += line + "\n";
  return with_checksum(text.substr(0, text.find("log ")) + log + text.substr(text.find("curves ")));
}

} // namespace

// Version 1 had no gaps, and is the same without inserted vertices.
BOOST_AUTO_TEST_CASE(version_1_is_read_if_no_vertex_was_inserted)
{
  const Mesh_soup soup = torus(16, 8, 2, 0.8);
  Curve_setting setting(soup), loaded(soup);
  add_curves(setting);
  setting.pull();
  const std::string text = with_checksum(replaced(saved(setting), "network 2\n", "network 1\n"));
  std::istringstream in(text);
  FG::read_network(in, loaded.network);
  BOOST_TEST((description(loaded) == description(setting)));

  std::istringstream with_vertex(with_log(text, {"v 0 0 0.25 0.25 0.5"}));
  Curve_setting empty(soup);
  BOOST_CHECK_EXCEPTION(FG::read_network(with_vertex, empty.network), FG::File_format_error, [](const FG::Error& e) {
    return std::string(e.what()).find("version 1, which does not record") != std::string::npos;
  });
}

// Insertions whose gap, halfedge and location do not fit together, and points outside the face or edge they are put
// into.
BOOST_AUTO_TEST_CASE(impossible_insertions_are_refused)
{
  const Mesh_soup soup = flat_grid(2, 2, Diagonal_rule::RISING);
  Curve_setting setting(soup);
  auto& t = setting.triangulation;
  Halfedge_index d = 0_h; // a diagonal
  while(t.is_border(d) || t.is_border(t.twin(d)) || t.length(d) < 1.1)
    ++d;
  const std::string face = std::to_string(d.idx()), other = std::to_string(t.twin(d).idx());
  Halfedge_index outside = 0_h;
  while(!t.is_border(outside))
    ++outside;
  const std::string border = std::to_string(outside.idx());
  const std::string text = saved(setting);
  const auto loads = [&](const std::vector<std::string>& log) {
    Curve_setting loaded(soup);
    std::istringstream in(with_log(text, log));
    FG::read_network(in, loaded.network);
    BOOST_TEST(loaded.triangulation.is_valid());
  };
  const auto refused = [&](const std::vector<std::string>& log) {
    check_throws<FG::File_format_error>(soup, with_log(text, log));
  };
  const Halfedge_index smallest = (std::min)({d, t.next(d), t.previous(d)}); // that a location is told from
  const std::string of_smallest = " 0 " + std::to_string(smallest.idx()) + " 0.25 0.25 0.5";
  loads({"v " + std::to_string(smallest.idx()) + of_smallest});
  const Halfedge_index first = FG::internal::first_side(t.edge(d));
  const std::string on_first = " 0 " + std::to_string(first.idx()) + " 0.5 0.5 0";
  loads({"e " + std::to_string(first.idx()) + on_first});
  loads({"e " + std::to_string(t.twin(first).idx()) + on_first});

  refused({"v " + other + of_smallest});                          // another face
  refused({"e " + std::to_string(smallest.idx()) + of_smallest}); // not on the edge
  refused({"v " + face + " 1 " + of_smallest.substr(3)});         // no such gap
  refused({"v " + face + " -1 " + of_smallest.substr(3)});
  refused({"v " + face + " 0 " + face + " 1 0 0"});  // a vertex
  refused({"v " + face + " 0 99999 0.25 0.25 0.5"}); // no face
  refused({"v " + face + " 0 " + face + " 0 0 0"});  // no point
  refused({"v " + face + " 0 " + face + " 0.25 -0.25 0.5"});
  refused({"v " + border + of_smallest});
  refused({"e " + border + on_first});
  refused({"e 99999" + on_first});

  const std::string flip = "f " + face; // over which the diagonal crosses itself as it was
  loads({flip, "e " + face + " 0 " + std::to_string(first.idx()) + " 0.5 0.5 0"});
  refused({flip, "e " + face + " 2 " + std::to_string(first.idx()) + " 0.5 0.5 0"});
}

BOOST_AUTO_TEST_CASE(another_version_is_refused)
{
  const Mesh_soup soup = cube(2);
  const std::string text = saved(Curve_setting(soup));
  for(const char* version : {"3", "0", "-1"})
    check_throws<FG::File_format_error>(
        soup, with_checksum(replaced(text, "network 2\n", "network " + std::string(version) + "\n")));
}

// As many ids of segments as that would take gigabytes.
BOOST_AUTO_TEST_CASE(too_many_ids_are_refused)
{
  const Mesh_soup soup = cube(2);
  const std::string text = saved(Curve_setting(soup));
  check_throws<FG::File_format_error>(soup, with_checksum(replaced(text, "curves 0 1\n", "curves 0 2000000000\n")));
}

// Edges that are not there, also those of which twice the number is too large, or that of another one.
BOOST_AUTO_TEST_CASE(edges_that_are_not_there_are_refused)
{
  const Mesh_soup soup = cube(2);
  Curve_setting setting(soup);
  for(int i = 0; i < 2; ++i)
    setting.network.add_curve(std::vector<Halfedge_index>{0_h});
  const std::string text = saved(setting);
  for(const char* edge : {"-1", "1000", "1073741824", "2147483647", "-2147483648"})
    check_throws<FG::File_format_error>(
        soup, with_checksum(replaced(text, "stacks 1\n0 2", "stacks 1\n" + std::string(edge) + " 2")));
}

// Faces that are laid out afresh are entries of the log: by request, and by flips whose errors have grown.
BOOST_AUTO_TEST_CASE(faces_laid_out_afresh)
{
  const Mesh_soup sphere = bumpy_sphere(6, 0.2, 4);
  Curve_setting setting(sphere);
  setting.add_path(0_v, 90_v);
  setting.pull(FG::Length_ratio_stop_predicate(0.9));
  for(Halfedge_index h : {0_h, 40_h, 80_h})
    BOOST_TEST(FG::internal::refresh_face(setting.triangulation, h));
  check_round_trip(setting, sphere);

  const Mesh_soup needles = needle_strip(60, 1, 1e-6);
  Certified_setting drifting(needles);
  drifting.add_path(Vertex_index(grid_vertex(60, 0, 0)), Vertex_index(grid_vertex(60, 60, 1)));
  drifting.pull();
  check_round_trip(drifting, needles);

  drifting.add_path(Vertex_index(grid_vertex(60, 0, 0)), Vertex_index(grid_vertex(60, 60, 1)));
  drifting.pull();
  drifting.network.clear(); // the flips stay
  const std::string text = saved(drifting);
  std::vector<std::string> lines = log_lines(text);
  BOOST_TEST((with_log(text, lines) == text));
  std::size_t first = 0;
  while(first < lines.size() && lines[first][0] != 'r')
    ++first;
  BOOST_REQUIRE(first > 0 && first < lines.size());
  std::size_t last = first;
  while(last + 1 < lines.size() && lines[last + 1][0] == 'r')
    ++last;
  lines.resize(last + 1);
  const std::string of_another_face = "r " + std::to_string(drifting.triangulation.number_of_halfedges() - 1);
  const auto refused = [&](const std::vector<std::string>& forged) {
    check_throws<FG::File_format_error, Certified_setting>(needles, with_log(text, forged));
  };
  lines[last] = of_another_face; // not what the flip has laid out
  refused(lines);
  lines.pop_back(); // the flip lays out a face that the log does not tell of
  refused(lines);
}

// Edges that cannot be flipped, since there is no face on a side, or the same one on both.
BOOST_AUTO_TEST_CASE(impossible_flips_are_refused)
{
  const Mesh_soup grid = flat_grid(2, 2, Diagonal_rule::RISING);
  const Curve_setting flat(grid);
  const std::string text = saved(flat);
  int border_halfedges = 0;
  for(Halfedge_index h : descriptors<Halfedge_index>(flat.triangulation.number_of_halfedges()))
    if(flat.triangulation.is_border(h)) {
      ++border_halfedges;
      for(Halfedge_index side : {h, flat.triangulation.twin(h)})
        check_throws<FG::File_format_error>(grid, with_log(text, {"f " + std::to_string(side.idx())}));
      check_throws<FG::File_format_error>(grid, with_log(text, {"r " + std::to_string(h.idx())}));
    }
  BOOST_TEST(border_halfedges == 8);

  const Mesh_soup spike = {{{0, 0, 3}, {1, 0, 0}, {-0.5, 0.87, 0}, {-0.5, -0.87, 0}},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  Curve_setting setting(spike);
  auto& triangulation = setting.triangulation;
  while(triangulation.clockwise(triangulation.outgoing(0_v)) != triangulation.outgoing(0_v))
    triangulation.flip(triangulation.outgoing(0_v));
  std::vector<std::string> lines = log_lines(saved(setting));
  BOOST_TEST(lines.size() == 2u);
  for(Halfedge_index side : {triangulation.outgoing(0_v), triangulation.twin(triangulation.outgoing(0_v))}) {
    lines.push_back("f " + std::to_string(side.idx()));
    check_throws<FG::File_format_error>(spike, with_log(saved(setting), lines));
    lines.pop_back();
  }
}

// A state changed in one place is none, leaves the network empty, and ready for another one.
BOOST_AUTO_TEST_CASE(forged_states)
{
  using State = FG::internal::Network_state;
  Curve_setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto vertex = [](int i, int j) { return Vertex_index(grid_vertex(4, i, j)); };
  setting.add({vertex(0, 2), vertex(1, 2), vertex(2, 2), vertex(3, 2)}, false);
  setting.add({vertex(1, 1), vertex(1, 2), vertex(2, 2), vertex(2, 1)}, false); // on the right of the first one
  setting.add({vertex(3, 3), vertex(4, 3), vertex(4, 4)}, true);
  BOOST_REQUIRE(setting.network.is_valid());
  const State state = FG::internal::network_state(setting.network);
  BOOST_REQUIRE_EQUAL(state.bundles.size(), 1u);
  const Index halfedges = setting.triangulation.number_of_halfedges();
  const std::vector<std::function<void(State&)>> forgeries = {
      [](State& s) { s.curves[0].segments[1].id = s.curves[0].segments[0].id; },
      [](State& s) { s.curves[2].segments[2].id = s.curves[0].segments[0].id; },
      [](State& s) { s.curves[2].segments[2].id = 0_s; },
      [](State& s) { s.curves[2].segments[2].id = FG::null_index; },
      [](State& s) { s.curves[2].segments[2].id = Segment_index(s.end_of_segment_ids); },
      [halfedges](State& s) { s.curves[0].segments[0].halfedge = Halfedge_index(halfedges); },
      [](State& s) { s.curves[0].segments[0].halfedge = FG::null_index; },
      [](State& s) { s.curves[0].segments[1].halfedge = s.curves[2].segments[1].halfedge; },
      [](State& s) { s.curves[0].is_closed = true; },
      [halfedges](State& s) { s.bundles[0].edge = Edge_index(halfedges / 2); },
      [](State& s) { s.bundles[0].edge = FG::null_index; },
      [](State& s) { s.bundles[0].segments[0] = s.curves[2].segments[0].id; },
      [](State& s) { s.bundles[0].segments.pop_back(); }};
  using Internals = FG::internal::Internals<decltype(setting.network)>;
  setting.network.clear();
  for(std::size_t i = 0; i < forgeries.size(); ++i) {
    State forged = state;
    forgeries[i](forged);
    BOOST_TEST(!Internals::restore(setting.network, forged), "forgery " << i);
    BOOST_TEST(setting.network.number_of_curves() == 0);
    BOOST_TEST(setting.triangulation.number_of_holds() == 0u);
    for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
      BOOST_REQUIRE(setting.network.bundle(e).empty());
  }
  BOOST_REQUIRE(Internals::restore(setting.network, state));
  BOOST_TEST(setting.network.bundle(state.bundles[0].edge) == state.bundles[0].segments,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(another_mesh)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.3, 1);
  Curve_setting setting(soup);
  add_curves(setting);
  const std::string text = saved(setting);
  check_throws<FG::Input_mismatch_error>(bumpy_sphere(5, 0.3, 1), text);
  check_throws<FG::Input_mismatch_error>(bumpy_sphere(4, 0.3, 2), text);
  check_throws<FG::Input_mismatch_error>(scaled(soup, 1.0000001), text);
}
