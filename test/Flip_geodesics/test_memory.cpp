// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What records of flips take of memory, counted where it is allocated: bounded per flip however long the words of the
// edges are; limits that become a status; and what is left when an allocation fails.

#define BOOST_TEST_MODULE memory
#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <sstream>
#include <vector>

namespace {

// Each block begins with its size.
constexpr std::size_t header = alignof(std::max_align_t);
std::size_t bytes_in_use = 0, most_bytes_in_use = 0;
std::size_t allocations_left = std::numeric_limits<std::size_t>::max(); // until one fails

} // namespace

void* operator new(std::size_t size)
{
  if(allocations_left == 0)
    throw std::bad_alloc();
  --allocations_left;
  void* block = std::malloc(size + header);
  if(block == nullptr)
    throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  bytes_in_use += size;
  most_bytes_in_use = std::max(most_bytes_in_use, bytes_in_use);
  return static_cast<char*>(block) + header;
}

void operator delete(void* memory) noexcept
{
  if(memory == nullptr)
    return;
  void* block = static_cast<char*>(memory) - header;
  bytes_in_use -= *static_cast<std::size_t*>(block);
  std::free(block);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

// Those for arrays call the ones above in the standard library, and do not under a sanitizer.
void* operator new[](std::size_t size) { return operator new(size); }

void operator delete[](void* memory) noexcept { operator delete(memory); }

void operator delete[](void* memory, std::size_t) noexcept { operator delete(memory); }

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Halfedge_index;
using FG::Vertex_index;

using Triangulation =
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
using Setting = Basic_curve_setting<Triangulation>;
using Status = FG::Shortening_status;

std::size_t number_of_flips(const Triangulation& triangulation)
{
  std::size_t flips = 0;
  for(std::size_t i = 0; i < triangulation.log_position(); ++i)
    flips += triangulation.flip_record(i).hp != FG::null_index ? 1 : 0;
  return flips;
}

std::size_t longest_word(const Setting& setting)
{
  std::size_t longest = 0;
  setting.network.for_each_segment(0_c, [&](FG::Segment_index s) {
    longest = std::max(longest, setting.triangulation.edge_sequence(setting.network.halfedge(s)).crossed.size());
  });
  return longest;
}

// The rest belongs to the curve, and to blocks that are not yet full.
void check_told_bytes(const Setting& setting, std::size_t before)
{
  const std::size_t told = setting.triangulation.memory_of_records();
  BOOST_TEST(told <= bytes_in_use - before);
  BOOST_TEST(told >= (bytes_in_use - before) * 9 / 10);
}

/// What a long shortening takes, as it is allocated and as it is told; a vector per word would take `longest_word()`.
void check_bytes_per_flip(const Mesh_soup& soup, Vertex_index source, Vertex_index target)
{
  Setting setting(soup);
  const std::vector<Halfedge_index> path = Setting::Search(setting.triangulation)(source, target);
  const std::size_t before = bytes_in_use;
  most_bytes_in_use = before;
  setting.network.add_curve(path);
  const FG::Shortening_report report = setting.pull();
  BOOST_TEST((report.curves[0].status == Status::LOCALLY_SHORTEST));

  const std::size_t flips = number_of_flips(setting.triangulation);
  const std::size_t most = most_bytes_in_use - before, told = setting.triangulation.memory_of_records();
  BOOST_TEST_MESSAGE(flips << " flips, " << most / flips << " bytes each at most, " << told / flips << " told");
  BOOST_TEST(flips > 100000u);
  BOOST_TEST(longest_word(setting) > 900u);
  BOOST_TEST(most <= 200 * flips);
  check_told_bytes(setting, before);

  setting.network.clear();
  setting.triangulation.rollback();
  constexpr std::size_t kept_for_reuse = 16 << 20;
  BOOST_TEST(bytes_in_use - before <= kept_for_reuse);
  BOOST_TEST(setting.triangulation.memory_of_records() < 100 * path.size() * sizeof(double));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_flip_on_a_strip_of_needles_takes_few_bytes)
{
  constexpr int n = 500;
  const Vertex_index source(grid_vertex(n, 0, 0)), target(grid_vertex(n, n, 1));
  check_bytes_per_flip(needle_strip(n, 1, 1e-6), source, target);
}

BOOST_AUTO_TEST_CASE(a_path_along_a_lantern_takes_few_flips_and_few_bytes)
{
  Setting setting(lantern(3, 1000));
  const std::vector<Halfedge_index> path = Setting::Search(setting.triangulation)(2900_v, 10_v);
  const std::size_t before = bytes_in_use;
  most_bytes_in_use = before;
  FG::add_straightened_path(setting.network, path);
  setting.pull();
  BOOST_TEST(longest_word(setting) > 900u);
  BOOST_TEST(number_of_flips(setting.triangulation) < 4 * longest_word(setting));
  BOOST_TEST(most_bytes_in_use - before < std::size_t(7 << 20));
  check_told_bytes(setting, before);
}

BOOST_AUTO_TEST_CASE(a_limit_of_memory_is_a_status)
{
  constexpr int n = 200;
  const Mesh_soup soup = needle_strip(n, 1, 1e-3);
  const Vertex_index source(grid_vertex(n, 0, 0)), target(grid_vertex(n, n, 1));
  constexpr std::size_t limit = 1 << 20;
  Setting setting(soup);
  setting.add_path(source, target);
  FG::Shortener<Setting::Network> shortener(setting.network);
  BOOST_TEST(!shortener.run(FG::Memory_stop_predicate(limit)));
  // The step at which it stops is taken back, but the words that were derived for it stay.
  BOOST_TEST(setting.triangulation.memory_of_records() <= limit * 11 / 10);
  BOOST_TEST(setting.triangulation.memory_of_records() > limit * 9 / 10);
  const FG::Shortening_report stopped = shortener.report();
  BOOST_TEST((stopped.curves[0].status == Status::MEMORY_LIMIT));
  BOOST_TEST(!stopped.is_complete());
  BOOST_TEST(FG::to_string(stopped.curves[0].status) == "MEMORY_LIMIT");
  BOOST_TEST(stopped.curves[0].length < stopped.curves[0].initial_length);
  BOOST_TEST(setting.triangulation.is_valid());
  BOOST_TEST(setting.network.is_valid());

  BOOST_TEST(shortener.run()); // goes on where it was stopped
  Setting other(soup);
  const FG::Curve_report whole = (other.add_path(source, target), other.pull().curves[0]);
  BOOST_TEST(shortener.report().curves[0].length == whole.length);
  BOOST_TEST((setting.flips() == other.flips()));
}

BOOST_AUTO_TEST_CASE(a_path_is_not_straightened_beyond_a_limit_of_memory)
{
  Setting setting(lantern(3, 300));
  const std::vector<Halfedge_index> path = Setting::Search(setting.triangulation)(812_v, 149_v);
  constexpr std::size_t limit = 50000;
  FG::add_straightened_path(setting.network, path, limit);
  BOOST_TEST(setting.triangulation.log_position() == 0u);
  BOOST_TEST((setting.network.halfedges(0_c) == path));
  const FG::Shortening_report report = setting.pull(FG::Memory_stop_predicate(limit));
  BOOST_TEST((report.curves[0].status == Status::MEMORY_LIMIT));
}

// Pulls curves while every allocation fails in turn, and checks that what there is stays valid; `add(setting)` makes
// the curves, `check(setting)` goes on with them. Returns how many allocations there were.
template <class Add, class Check>
std::size_t fail_each_allocation(const Mesh_soup& soup, const Add& add, const Check& check)
{
  std::size_t failures = 0;
  for(std::size_t allocations = 0; failures == allocations; ++allocations) {
    Setting failing(soup);
    add(failing);
    allocations_left = allocations;
    try {
      failing.pull();
    } catch(const std::bad_alloc&) {
      ++failures;
    }
    allocations_left = std::numeric_limits<std::size_t>::max();
    BOOST_TEST_REQUIRE(failing.triangulation.is_valid());
    BOOST_TEST_REQUIRE(failing.network.is_valid());
    check(failing);
  }
  return failures;
}

// What is left goes on to the same geodesic.
BOOST_AUTO_TEST_CASE(a_failed_allocation_leaves_all_valid)
{
  const Mesh_soup soup = needle_strip(40, 2, 1e-6);
  const Vertex_index source(grid_vertex(40, 0, 0)), target(grid_vertex(40, 40, 2));
  Setting setting(soup);
  const double length = setting.pulled_path(source, target).length;
  const std::size_t failures = fail_each_allocation(
      soup, [&](Setting& failing) { failing.add_path(source, target); },
      [&](Setting& failing) {
        const FG::Curve_report report = failing.pull().curves[0];
        BOOST_TEST_REQUIRE((report.status == Status::LOCALLY_SHORTEST));
        BOOST_TEST_REQUIRE(std::abs(report.length - length) <= 1e-12 * length);
        failing.network.clear();
        failing.triangulation.rollback();
        BOOST_TEST_REQUIRE(failing.triangulation.is_valid());
      });
  BOOST_TEST(failures > 20u);
}

// As above, with the step for a loop of one segment, which is taken back as a whole.
BOOST_AUTO_TEST_CASE(a_failed_allocation_leaves_a_loop_valid)
{
  const Vertex_sequence loop = disk_ring(6, 1);
  const std::size_t failures = fail_each_allocation(
      thirteen_vertex_cone_disk(), [&](Setting& failing) { failing.add(loop, true); },
      [](Setting& failing) { BOOST_TEST_REQUIRE(failing.pull().is_complete()); });
  BOOST_TEST(failures > 10u);
}

// The flips of a shortening once more, each with every allocation failing first, those for faces laid out afresh too.
BOOST_AUTO_TEST_CASE(a_flip_without_memory_changes_nothing)
{
  const Mesh_soup soup = needle_strip(60, 1, 1e-6);
  Setting done(soup), replayed(soup);
  done.add_path(Vertex_index(grid_vertex(60, 0, 0)), Vertex_index(grid_vertex(60, 60, 1)));
  done.pull();
  Triangulation& t = replayed.triangulation;
  std::size_t failures = 0;
  for(std::size_t i = 0; i < done.triangulation.log_position(); ++i) {
    const auto& record = done.triangulation.flip_record(i);
    if(record.hp == FG::null_index)
      continue;
    const std::size_t before = t.log_position();
    const FG::Edge_index edge = t.edge(record.h);
    const FG::Index version = t.version(edge);
    const Halfedge_index next = t.next(record.h);
    bool is_flipped = false;
    for(std::size_t allocations = 0; !is_flipped; ++allocations) {
      allocations_left = allocations;
      try {
        t.flip(record.h);
        is_flipped = true;
      } catch(const std::bad_alloc&) {
        ++failures;
      }
      allocations_left = std::numeric_limits<std::size_t>::max();
      if(!is_flipped)
        BOOST_TEST_REQUIRE((t.log_position() == before && t.version(edge) == version && t.next(record.h) == next));
    }
  }
  BOOST_TEST(failures > 50u);
  BOOST_TEST((replayed.flips() == done.flips()));
}

// Inserts a point, while every allocation fails in turn and `check` looks at what there is then, until none does. Adds
// to the failures.
template <class Insert, class Check>
Vertex_index insert_at_last(const Insert& insert, const Check& check, std::size_t& failures)
{
  for(std::size_t allocations = 0;; ++allocations) {
    Vertex_index x = FG::null_index;
    allocations_left = allocations;
    try {
      x = insert();
    } catch(const std::bad_alloc&) {
      ++failures;
    }
    allocations_left = std::numeric_limits<std::size_t>::max();
    if(x != FG::null_index)
      return x;
    check();
  }
}

// Points in faces and on edges.
BOOST_AUTO_TEST_CASE(an_insertion_without_memory_changes_nothing)
{
  Setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation& t = setting.triangulation;
  std::size_t failures = 0;
  for(FG::Input_halfedge_index h(0); h.idx() < 60; ++h) {
    if(t.input().is_border(h))
      continue;
    const FG::Surface_location location = {h, {{0.25, 0.5, h.idx() % 3 == 0 ? 0 : 0.25}}};
    const FG::Index vertices = t.number_of_vertices(), edges = t.number_of_edges();
    const std::size_t before = t.log_position();
    const auto is_as_before = [&] {
      BOOST_TEST_REQUIRE(t.number_of_vertices() == vertices);
      BOOST_TEST_REQUIRE(t.number_of_edges() == edges);
      BOOST_TEST_REQUIRE(t.log_position() == before);
      BOOST_TEST_REQUIRE(t.is_valid());
    };
    const Vertex_index x = insert_at_last([&] { return t.insert(location); }, is_as_before, failures);
    BOOST_TEST_REQUIRE(x == Vertex_index(vertices));
    BOOST_TEST_REQUIRE(t.is_valid());
  }
  BOOST_TEST(failures > 100u);
  t.rollback();
  BOOST_TEST(t.number_of_vertices() == 25);
  BOOST_TEST(t.is_valid());
}

// Points on an edge under curves, more of them each time.
BOOST_AUTO_TEST_CASE(an_insertion_under_curves_without_memory_changes_nothing)
{
  std::size_t failures = 0;
  for(int curves = 1; curves <= 20; ++curves) {
    Setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
    for(int i = 0; i < curves; ++i)
      setting.add_path(Vertex_index(grid_vertex(4, 1, 2)), Vertex_index(grid_vertex(4, 2, 2)));
    const Halfedge_index h = setting.network.halfedge(setting.network.first_segment(0_c));
    const std::vector<FG::Segment_index> stack = setting.network.bundle(Triangulation::edge(h));
    BOOST_TEST_REQUIRE(stack.size() == static_cast<std::size_t>(curves));
    const auto is_as_before = [&] {
      BOOST_TEST_REQUIRE(setting.triangulation.log_position() == 0u);
      BOOST_TEST_REQUIRE((setting.network.bundle(Triangulation::edge(h)) == stack));
      BOOST_TEST_REQUIRE(setting.network.is_valid());
    };
    const FG::Surface_location location = {FG::internal::as_input(h), {{0.25, 0.75, 0}}};
    const Vertex_index x = insert_at_last([&] { return setting.network.insert(location); }, is_as_before, failures);
    BOOST_TEST_REQUIRE(x == 25_v);
    BOOST_TEST_REQUIRE(setting.network.is_valid());
    for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(curves))
      BOOST_TEST_REQUIRE(setting.network.halfedges(c).size() == 2u);
  }
  BOOST_TEST(failures > 100u);
}

// Wherever a computation ran out of memory, what it knows is right, and the next one goes on to the same distances.
BOOST_AUTO_TEST_CASE(a_field_goes_on_when_there_is_memory_again)
{
  using Field = FG::Geodesic_distance_field<Triangulation>;
  const auto mesh = to_mesh<Triangulation::Triangle_mesh>(bumpy_sphere(6, 0.3, 1));
  const Triangulation triangulation(mesh);
  const auto vertices = FG::internal::descriptors<Vertex_index>(triangulation.number_of_vertices());
  for(const auto extent : {FG::Distance_field_extent::EVERYWHERE, FG::Distance_field_extent::VERTICES_ONLY}) {
    const auto make_field = [&] {
      Field field(triangulation, mesh, CGAL::parameters::extent(extent));
      field.add_source(3_v);
      field.add_source(FG::Surface_location{FG::Input_halfedge_index(40), {{0.25, 0.5, 0.25}}}, 0.05);
      return field;
    };
    Field expected = make_field();
    expected.compute();
    std::size_t failures = 0;
    bool is_complete = false;
    for(std::size_t allocations = 0; !is_complete; ++allocations) {
      Field field = make_field();
      allocations_left = allocations;
      try {
        field.compute();
        is_complete = true;
      } catch(const std::bad_alloc&) {
        ++failures;
      }
      allocations_left = std::numeric_limits<std::size_t>::max();
      for(Vertex_index v : vertices)
        if(field.distance(v) < std::numeric_limits<double>::infinity())
          BOOST_TEST_REQUIRE(std::abs(field.distance(v) - expected.distance(v)) <= 1e-12);
      BOOST_TEST_REQUIRE((field.compute().status == FG::Distance_field_status::COMPLETE));
      for(Vertex_index v : vertices)
        BOOST_TEST_REQUIRE(std::abs(field.distance(v) - expected.distance(v)) <= 1e-12);
    }
    BOOST_TEST(failures > 30u);
  }
}

// What adds a curve by flips takes them back, so that the next one can be added.
template <class Add>
void add_while_each_allocation_fails(const Mesh_soup& soup, std::size_t least_failures, const Add& add)
{
  std::size_t failures = 0;
  bool is_added = false;
  for(std::size_t allocations = 0; !is_added; ++allocations) {
    Setting setting(soup);
    Setting::Search search(setting.triangulation);
    const std::vector<Halfedge_index> path = search(Vertex_index(0), Vertex_index(27));
    allocations_left = allocations;
    try {
      add(setting, search, path);
      is_added = true;
    } catch(const std::bad_alloc&) {
      ++failures;
    }
    allocations_left = std::numeric_limits<std::size_t>::max();
    BOOST_TEST_REQUIRE(setting.network.number_of_curves() == (is_added ? 1 : 0));
    BOOST_TEST_REQUIRE((is_added || setting.triangulation.log_position() == 0));
    BOOST_TEST_REQUIRE(setting.triangulation.is_valid());
  }
  BOOST_TEST(failures > least_failures);
}

BOOST_AUTO_TEST_CASE(a_path_is_added_by_flips_or_nothing_is_flipped)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.2, 1);
  add_while_each_allocation_fails(soup, 10u, [](Setting& setting, auto&, const std::vector<Halfedge_index>& path) {
    FG::add_straightened_path(setting.network, path);
  });
  add_while_each_allocation_fails(soup, 10u, [](Setting& setting, auto& search, const auto&) {
    FG::add_shortest_path(setting.network, search, Vertex_index(0), Vertex_index(27));
  });
}

// Streams tell of a failed allocation by their state, so that a text can seem to be cut off.
BOOST_AUTO_TEST_CASE(a_network_is_loaded_as_a_whole_or_not_at_all)
{
  const Mesh_soup soup = needle_strip(12, 1, 1e-6);
  Setting original(soup);
  original.add_path(Vertex_index(grid_vertex(12, 0, 0)), Vertex_index(grid_vertex(12, 12, 1)));
  original.pull();
  std::ostringstream out;
  FG::write_network(out, original.network);
  std::size_t failures = 0;
  bool is_loaded = false;
  for(std::size_t allocations = 0; !is_loaded; ++allocations) {
    Setting setting(soup);
    std::istringstream in(out.str());
    allocations_left = allocations;
    try {
      FG::read_network(in, setting.network);
      is_loaded = true;
    } catch(const std::bad_alloc&) {
      ++failures;
    } catch(const FG::File_format_error&) {
      ++failures;
    }
    allocations_left = std::numeric_limits<std::size_t>::max();
    BOOST_TEST_REQUIRE(setting.network.number_of_curves() == (is_loaded ? 1 : 0));
    BOOST_TEST_REQUIRE(setting.triangulation.log_position() == (is_loaded ? original.triangulation.log_position() : 0));
    BOOST_TEST_REQUIRE(setting.network.is_valid());
  }
  BOOST_TEST(failures > 10u);
}
