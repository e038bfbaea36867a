// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE certificate_falsehoods

#include "Curve_setting.h"
#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

/*
 * True certificates, and then something changed that makes them false, by as little as there is: a letter of a word, a
 * unit in the last place of a vertex. What is true is known by rational arithmetic: the surfaces are screens, flat or
 * folded, that unfold to the plane by rational numbers, but for the width of all columns.
 */
namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Halfedge_index;
using FG::Input_halfedge_index;
using FG::Vertex_index;

namespace {

// A triangulation that can be made to lie about its words.
class Planted_triangulation : public Double_triangulation<Surface>
{
  using Base = Double_triangulation<Surface>;

public:
  using Base::Base;

  void plant(Halfedge_index h, const FG::Edge_sequence& word) { m_planted = {h, word}; }
  void uproot() { m_planted.reset(); }

  FG::Edge_sequence edge_sequence(Halfedge_index h) const
  {
    return m_planted && m_planted->first == h ? m_planted->second : Base::edge_sequence(h);
  }

private:
  std::optional<std::pair<Halfedge_index, FG::Edge_sequence>> m_planted;
};

using Setting = Basic_curve_setting<Planted_triangulation>;
using Verdict = FG::Verdict;

// ---------------------------------------------------------------- screens

constexpr int columns = 5, rows = 4;

// Folded like a fan, in columns of one width: 5, or a root. What is straight does not depend on it.
enum class Folds { NONE, RATIONAL, ROOTS };

// The vertices of column i at x = 5 i, unfolded, in widths of a column.
struct Screen
{
  Folds folds;
  FG::internal::Indexed_by<Vertex_index, std::array<double, (columns + 1) * (rows + 1)>> y;
  Mesh_soup connectivity;

  auto vertices() const { return FG::internal::descriptors<Vertex_index>(static_cast<FG::Index>(y.size())); }

  Screen(Folds folds_, unsigned seed)
    : folds(folds_)
    , connectivity(flat_grid(columns, rows, Diagonal_rule::RANDOM))
  {
    Random_numbers random(seed);
    for(Vertex_index v : vertices()) // in eighths
      y[v] = 5 * row(v) + (random.below(25) - 12) / 8.0;
  }

  static Vertex_index vertex(int column, int row) { return Vertex_index(grid_vertex(columns, column, row)); }
  static int column(Vertex_index v) { return v.idx() % (columns + 1); }
  static int row(Vertex_index v) { return v.idx() / (columns + 1); }

  Coordinates point(Vertex_index v) const
  {
    const double i = column(v);
    if(folds == Folds::NONE)
      return {5 * i, y[v], 0};
    return {3 * i, y[v], column(v) % 2 == 0 ? 0.0 : (folds == Folds::RATIONAL ? 4.0 : 5.0)};
  }

  Mesh_soup soup() const
  {
    Mesh_soup result = connectivity;
    for(Vertex_index v : vertices())
      result.points[v.idx()] = point(v);
    return result;
  }

  bool is_ordered() const // so that no face is turned over
  {
    for(Vertex_index v : vertices())
      if(row(v) < rows && !(y[v] < y[vertex(column(v), row(v) + 1)]))
        return false;
    return true;
  }
};

void move(Setting& setting, const Screen& screen)
{
  for(Vertex_index v : screen.vertices()) {
    const Coordinates p = screen.point(v);
    setting.mesh.point(setting.triangulation.vertex(v)) = {p[0], p[1], p[2]};
  }
}

using Rational = boost::multiprecision::cpp_rational;

struct Place
{
  Rational x, y;
};

// Where a vertex is, unfolded.
Place place(const Setting& setting, const Screen& screen, Vertex_index v)
{
  if(!setting.triangulation.is_inserted(v))
    return {5 * Screen::column(v), Rational(screen.y[v])};
  const FG::Surface_location at = setting.triangulation.location(v);
  const auto& input = setting.triangulation.input();
  Place result = {0, 0};
  Rational sum = 0;
  Input_halfedge_index h = at.halfedge;
  for(int i = 0; i < 3; ++i, h = input.next(h)) {
    const Rational weight(at.weights[i]);
    const Place corner = place(setting, screen, input.tail(h));
    result = {result.x + weight * corner.x, result.y + weight * corner.y};
    sum += weight;
  }
  return {result.x / sum, result.y / sum};
}

// Positive if r lies on the left of the line from p to q.
int orientation(const Place& p, const Place& q, const Place& r)
{
  const Rational sine = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return sine > 0 ? 1 : (sine < 0 ? -1 : 0);
}

// Does the segment with a word stay in its strip?
bool is_straight(const Setting& setting, const Screen& screen, const FG::Edge_sequence& word)
{
  const Place p = place(setting, screen, word.tail), q = place(setting, screen, word.head);
  const auto& input = setting.triangulation.input();
  for(Input_halfedge_index h : word.crossed)
    if(orientation(p, q, place(setting, screen, input.tail(h))) > 0 ||
       orientation(p, q, place(setting, screen, input.tail(FG::internal::twin_index(h)))) < 0)
      return false;
  return true;
}

// The point half way from column i to the next one, in the face that has a corner at `corner` and two in the other
// column, at its middle height there.
FG::Surface_location middle_of_face(const Setting& setting, Vertex_index lone, bool is_leftmost)
{
  const auto& input = setting.triangulation.input();
  for(Input_halfedge_index h : FG::internal::descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(input.tail(h) != lone || input.is_border(h))
      continue;
    const int a = Screen::column(input.tail(input.next(h)));
    const int b = Screen::column(input.tail(input.next(input.next(h))));
    if(a == b && (a > Screen::column(lone)) == is_leftmost && a != Screen::column(lone))
      return {h, {{0.5, 0.25, 0.25}}};
  }
  return {};
}

// A curve of one segment between two ends in the first and last columns, if there is one.
bool add_segment(Setting& setting, int inserted, Vertex_index from, Vertex_index to)
{
  Vertex_index ends[2] = {from, to};
  for(int k = 2 - inserted; k < 2; ++k) { // both, or the last
    const FG::Surface_location middle = middle_of_face(setting, ends[k], k == 0);
    if(middle.halfedge == FG::null_index)
      return false;
    ends[k] = setting.network.insert(middle);
  }
  setting.network.add_curve(FG::shortest_intrinsic_edge_path(setting.triangulation, ends[0], ends[1]));
  setting.pull();
  return setting.network.halfedges(0_c).size() == 1;
}

double moved_by_units(double y, int units)
{
  for(; units > 0; --units)
    y = std::nextafter(y, std::numeric_limits<double>::infinity());
  for(; units < 0; ++units)
    y = std::nextafter(y, -std::numeric_limits<double>::infinity());
  return y;
}

struct Tally
{
  int straight = 0, bent = 0, touching = 0;
};

// Moves vertex v to the line of the only segment, and a little further, and compares the certificate with the truth.
void move_across(const Screen& screen, int inserted, Vertex_index from, Vertex_index to, Vertex_index v, Tally& tally)
{
  for(int units : {-1000000000, -2, -1, 0, 1, 2, 1000000000}) {
    Setting setting(screen.soup()); // afresh, for what is known of the input's faces is kept
    BOOST_REQUIRE(add_segment(setting, inserted, from, to));
    const FG::Edge_sequence word = setting.triangulation.edge_sequence(setting.network.halfedges(0_c).front());
    Screen moved = screen;
    for(int round = 0; round < 3; ++round) { // the ends may move along
      const Place p = place(setting, moved, word.tail), q = place(setting, moved, word.head);
      const Rational x = 5 * Screen::column(v), y = p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x);
      moved.y[v] = y.convert_to<double>();
    }
    if(std::abs(units) > 2)
      moved.y[v] += units > 0 ? 0.25 : -0.25;
    else
      moved.y[v] = moved_by_units(moved.y[v], units);
    if(!moved.is_ordered())
      continue;
    move(setting, moved);
    const bool is_true = is_straight(setting, moved, word);
    const Verdict verdict = FG::certify(setting.network).curves[0].verdict();
    BOOST_TEST((verdict == (is_true ? Verdict::PROVEN : Verdict::BENT_SEGMENT)),
               "folds " << static_cast<int>(screen.folds) << ", from " << from.idx() << " to " << to.idx()
                        << ", vertex " << v.idx() << ", " << units);
    const int side =
        orientation(place(setting, moved, word.tail), place(setting, moved, word.head), place(setting, moved, v));
    (side == 0 ? tally.touching : (is_true ? tally.straight : tally.bent)) += 1;
  }
}

} // namespace

// On either side, by a quarter and by a unit in the last place; with ends at vertices and inside faces.
BOOST_AUTO_TEST_CASE(a_segment_that_leaves_its_strip_is_bent)
{
  for(Folds folds : {Folds::NONE, Folds::RATIONAL, Folds::ROOTS})
    for(int inserted : {0, 1, 2}) {
      Tally tally;
      for(unsigned seed = 1; seed <= 3; ++seed) {
        const Screen screen(folds, seed);
        for(int j = 0; j <= rows; ++j)
          for(int k = 0; k <= rows; ++k) {
            const Vertex_index from = Screen::vertex(0, j), to = Screen::vertex(inserted > 0 ? 5 : 4, k);
            Setting setting(screen.soup());
            if(!add_segment(setting, inserted, from, to))
              continue;
            const FG::Edge_sequence word = setting.triangulation.edge_sequence(setting.network.halfedges(0_c).front());
            const auto& input = setting.triangulation.input();
            for(std::size_t i = 1; i + 1 < word.crossed.size(); ++i)
              for(Vertex_index v : {input.tail(word.crossed[i]), input.tail(FG::internal::twin_index(word.crossed[i]))})
                if(Screen::column(v) >= 1 && Screen::column(v) <= (inserted > 0 ? 4 : 3) && i % 2 == 1)
                  move_across(screen, inserted, from, to, v, tally);
          }
      }
      BOOST_TEST(tally.straight > 100);
      BOOST_TEST(tally.bent > 100);
      BOOST_TEST(tally.touching > (inserted == 1 ? 0 : 10));
    }
}

namespace {

// All words that differ by a letter: one left out, put in, replaced, two swapped.
std::vector<FG::Edge_sequence> words_changed_by_a_letter(const Setting& setting, const FG::Edge_sequence& word,
                                                         Random_numbers& random)
{
  const auto& input = setting.triangulation.input();
  std::vector<FG::Edge_sequence> result;
  const auto add = [&](const FG::Edge_sequence& changed) {
    if(changed.crossed != word.crossed || changed.along != word.along)
      result.push_back(changed);
  };
  const auto beside = [&](Input_halfedge_index h) { // the letters that could be taken for h
    using FG::internal::twin_index;
    const Input_halfedge_index t = twin_index(h);
    std::vector<Input_halfedge_index> letters = {t, Input_halfedge_index(random.below(input.number_of_halfedges()))};
    for(Input_halfedge_index side : {h, t})
      if(!input.is_border(side)) {
        const Input_halfedge_index second = input.next(side), third = input.next(second);
        letters.insert(letters.end(), {second, third, twin_index(second), twin_index(third)});
      }
    return letters;
  };
  for(std::size_t i = 0; i < word.crossed.size(); ++i) {
    FG::Edge_sequence changed = word;
    changed.crossed.erase(changed.crossed.begin() + static_cast<std::ptrdiff_t>(i));
    add(changed);
    changed = word;
    if(i > 0)
      std::swap(changed.crossed[i - 1], changed.crossed[i]);
    add(changed);
    for(Input_halfedge_index letter : beside(word.crossed[i])) {
      changed = word;
      changed.crossed[i] = letter;
      add(changed);
      for(std::size_t at : {i, i + 1}) {
        changed = word;
        changed.crossed.insert(changed.crossed.begin() + static_cast<std::ptrdiff_t>(at), letter);
        add(changed);
      }
    }
  }
  for(Input_halfedge_index letter : beside(word.along != FG::null_index ? word.along : word.crossed.front())) {
    FG::Edge_sequence changed = word;
    changed.crossed.clear();
    changed.along = letter;
    add(changed);
  }
  for(Vertex_index v : {word.tail, word.head}) { // and of another edge
    FG::Edge_sequence changed = word;
    (v == word.tail ? changed.tail : changed.head) = Vertex_index((v.idx() + 1) % input.number_of_vertices());
    result.push_back(changed);
  }
  return result;
}

int plant_falsehoods(Setting& setting, Random_numbers& random)
{
  int result = 0;
  setting.network.for_each_segment(0_c, [&](FG::Segment_index s) {
    const Halfedge_index h = setting.network.halfedge(s);
    const FG::Edge_sequence word = setting.triangulation.edge_sequence(h);
    if(word.along == FG::null_index && word.crossed.empty())
      return;
    for(const FG::Edge_sequence& changed : words_changed_by_a_letter(setting, word, random)) {
      setting.triangulation.plant(h, changed);
      const FG::Curve_certificate certificate = FG::certify(setting.network).curves[0];
      setting.triangulation.uproot();
      BOOST_TEST((certificate.verdict() == Verdict::BENT_SEGMENT));
      BOOST_TEST(certificate.segment == s);
      ++result;
    }
  });
  return result;
}

} // namespace

// Between two vertices of a surface without positive curvature there is one straight word.
BOOST_AUTO_TEST_CASE(a_word_changed_by_a_letter_is_found)
{
  Random_numbers random(3);
  for(const Mesh_soup& soup :
      {Screen(Folds::NONE, 1).soup(), Screen(Folds::RATIONAL, 2).soup(),
       jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1), needle_strip(7, 7, 0x1p20), saddle_disk(6, 3, 8)})
  {
    int falsehoods = 0;
    for(int i = 0; i < 10; ++i) {
      Setting setting(soup);
      const int n = setting.triangulation.number_of_vertices();
      const int u = random.below(n);
      setting.add_path(Vertex_index(u), Vertex_index((u + 1 + random.below(n - 1)) % n));
      setting.pull();
      if(FG::certify(setting.network).is_locally_shortest())
        falsehoods += plant_falsehoods(setting, random);
    }
    BOOST_TEST(falsehoods > 100);
  }
}

// The same between points of faces and edges.
BOOST_AUTO_TEST_CASE(a_word_between_points_changed_by_a_letter_is_found)
{
  Random_numbers random(4);
  int falsehoods = 0;
  for(int i = 0; i < 20; ++i) {
    Setting setting(Screen(i % 2 != 0 ? Folds::RATIONAL : Folds::NONE, 1 + i).soup());
    Vertex_index ends[2];
    for(int k = 0; k < 2; ++k) {
      const Input_halfedge_index h = setting.triangulation.input().index(
          halfedge(Surface::Face_index(random.below(static_cast<int>(setting.mesh.number_of_faces()))), setting.mesh));
      ends[k] = setting.network.insert({h, {{0.25, 0.5, i % 3 == 0 ? 0.0 : 0.25}}});
    }
    if(ends[0] == ends[1])
      continue;
    setting.network.add_curve(FG::shortest_intrinsic_edge_path(setting.triangulation, ends[0], ends[1]));
    setting.pull();
    if(FG::certify(setting.network).is_locally_shortest())
      falsehoods += plant_falsehoods(setting, random);
  }
  BOOST_TEST(falsehoods > 100);
}

// ---------------------------------------------------------------- joints

namespace {

// The verdict on the path from vertex 2 over the new vertex to vertex 3, in the diamond of two triangles over the edge
// from vertex 0 to vertex 1; with the sides of the joint.
FG::Curve_certificate verdict_on_joint(const Mesh_soup& soup, const FG::Surface_location& middle, bool is_reversed)
{
  Setting setting(soup);
  const Vertex_index x = setting.network.insert(middle);
  std::vector<Halfedge_index> path = {FG::internal::halfedge_between(setting.triangulation, 2_v, x),
                                      FG::internal::halfedge_between(setting.triangulation, x, 3_v)};
  if(is_reversed)
    path = {Planted_triangulation::twin(path[1]), Planted_triangulation::twin(path[0])};
  setting.network.add_curve(path);
  return FG::certify(setting.network).curves[0];
}

Input_halfedge_index halfedge_from_to(const Mesh_soup& soup, Vertex_index v, Vertex_index w)
{
  const Setting setting(soup);
  return FG::internal::as_input(FG::internal::halfedge_between(setting.triangulation, v, w));
}

} // namespace

// The middle of an edge that is a fold; the far vertex a unit in the last place to the left or to the right.
BOOST_AUTO_TEST_CASE(a_joint_at_a_point_of_an_edge_bent_by_a_unit_is_found)
{
  for(bool is_folded : {false, true})
    for(int units : {-1000, -1, 0, 1, 1000}) {
      const double x = moved_by_units(1, units);
      const Mesh_soup soup = {
          {{0, 0, 0}, {1, 0, 0}, {0, -5, 0}, is_folded ? Coordinates{x, 3, 4} : Coordinates{x, 5, 0}},
          {{0, 1, 3}, {1, 0, 2}}};
      const FG::Surface_location middle = {halfedge_from_to(soup, 0_v, 1_v), {{0.5, 0.5, 0}}};
      for(bool is_reversed : {false, true}) {
        const FG::Curve_certificate certificate = verdict_on_joint(soup, middle, is_reversed);
        BOOST_TEST((certificate.verdict() == (units == 0 ? Verdict::PROVEN : Verdict::BENT_JOINT)));
        if(units != 0)
          BOOST_TEST((certificate.side == ((units > 0) != is_reversed ? FG::Side::RIGHT : FG::Side::LEFT)));
      }
    }
}

// From a corner of a face through one point inside to another: straight if the weights of the other corners have one
// ratio.
BOOST_AUTO_TEST_CASE(a_joint_at_a_point_of_a_face_bent_by_a_unit_is_found)
{
  for(double height : {0.0, 1.0})
    for(int corner : {0, 1, 2})
      for(int units : {-1000, -1, 0, 1, 1000}) {
        const Mesh_soup soup = {{{0, 0, height}, {7, 1, 0}, {2, 5, 3 * height}}, {{0, 1, 2}}};
        Setting setting(soup);
        const Vertex_index start(corner), next((corner + 1) % 3);
        const Input_halfedge_index h =
            FG::internal::as_input(FG::internal::halfedge_between(setting.triangulation, start, next));
        const Vertex_index x = setting.network.insert({h, {{0.5, 0.25, 0.25}}});
        const Vertex_index y = setting.network.insert({h, {{0.25, moved_by_units(0.375, units), 0.375}}});
        setting.network.add_curve(
            std::vector<Halfedge_index>{FG::internal::halfedge_between(setting.triangulation, start, x),
                                        FG::internal::halfedge_between(setting.triangulation, x, y)});
        const FG::Curve_certificate certificate = FG::certify(setting.network).curves[0];
        BOOST_TEST((certificate.verdict() == (units == 0 ? Verdict::PROVEN : Verdict::BENT_JOINT)));
        if(units != 0) // more of the next corner is on the right
          BOOST_TEST((certificate.side == (units > 0 ? FG::Side::RIGHT : FG::Side::LEFT)));
      }
}

// A line through a vertex of a folded screen.
BOOST_AUTO_TEST_CASE(a_joint_at_a_vertex_bent_by_a_unit_is_found)
{
  for(Folds folds : {Folds::NONE, Folds::RATIONAL, Folds::ROOTS})
    for(int units : {-1000, -1, 0, 1, 1000}) {
      Screen screen(folds, 1);
      for(Vertex_index v : screen.vertices())
        screen.y[v] = 5 * Screen::row(v) + Screen::column(v);
      const Vertex_index v = Screen::vertex(2, 2);
      screen.y[v] = moved_by_units(screen.y[v], units);
      Setting setting(screen.soup());
      setting.add({Screen::vertex(1, 2), v, Screen::vertex(3, 2)}, false);
      const FG::Curve_certificate certificate = FG::certify(setting.network).curves[0];
      BOOST_TEST((certificate.verdict() == (units == 0 ? Verdict::PROVEN : Verdict::BENT_JOINT)));
      if(units != 0)
        BOOST_TEST((certificate.side == (units > 0 ? FG::Side::RIGHT : FG::Side::LEFT)));
    }
}

// ---------------------------------------------------------------- bounds of errors

// What is known up to an error is not decided within it.
BOOST_AUTO_TEST_CASE(angles_are_told_from_pi_beyond_their_error)
{
  constexpr double pi = boost::math::constants::pi<double>(), error = 1e-6;
  for(double part : {-0.9, -0.6, -0.4, 0.0, 0.4, 0.6, 0.9})
    BOOST_TEST((FG::internal::Wedge_angle{pi + part * error, error}.compare_with_straight() == CGAL::EQUAL));
  BOOST_TEST((FG::internal::Wedge_angle{pi + 1.1 * error, error}.compare_with_straight() == CGAL::LARGER));
  BOOST_TEST((FG::internal::Wedge_angle{pi - 1.1 * error, error}.compare_with_straight() == CGAL::SMALLER));
  for(double y : {0.0, -0.0, -1e-300, -1e-16}) // of an edge opposite its reference, up to rounding
    BOOST_TEST(std::abs(FG::internal::angle_from_reference({-1, y}) - pi) < 1e-15);
}

// The errors of a strip have a part of each of its faces, and decisions by it have a part of each of its errors.
BOOST_AUTO_TEST_CASE(errors_of_strips_are_counted_in_what_is_told_from_them)
{
  using FG::internal::double_double_vector_error;
  const Screen screen(Folds::ROOTS, 1);
  int strips = 0;
  for(int j = 0; j <= rows; ++j)
    for(int k = 0; k <= rows; ++k) {
      Setting setting(screen.soup());
      if(!add_segment(setting, 0, Screen::vertex(0, j), Screen::vertex(columns, k)))
        continue;
      const auto& triangulation = setting.triangulation;
      const Halfedge_index h = setting.network.halfedges(0_c).front();
      const FG::Edge_sequence word = triangulation.edge_sequence(h);
      if(word.crossed.empty())
        continue;
      ++strips;
      const FG::internal::Precise_strip<Planted_triangulation> precise(triangulation, word, true);
      const FG::internal::Precise_edge& edge = precise.edge();
      BOOST_TEST(edge.direction_error >= double_double_vector_error * static_cast<double>(word.crossed.size()));
      for(int side : {-1, 1}) { // off the line by half the error of its end
        const double size = edge.length / 2, off = side * edge.end_error / 2;
        const double x = edge.end.x.high / 2, y = edge.end.y.high / 2;
        FG::internal::Double_double_vector p = {{x, edge.end.x.low / 2}, {y, edge.end.y.low / 2}};
        p = p + FG::internal::Double_double_vector{{-off * y, 0}, {off * x, 0}};
        BOOST_TEST(!precise.side({p, 0}).is_certain());
        p = p + FG::internal::Double_double_vector{{-side * 0x1p-80 * y, 0}, {side * 0x1p-80 * x, 0}};
        BOOST_TEST(precise.side({p, 0}).is_certain());
        BOOST_TEST(!precise.side({p, 0x1p-70 * size}).is_certain());
      }
      const Halfedge_index g = triangulation.clockwise(h);
      if(g == FG::null_index)
        continue;
      const FG::internal::Strip<Planted_triangulation> from(triangulation, word);
      const FG::internal::Strip<Planted_triangulation> to(triangulation, triangulation.edge_sequence(g));
      const double corners = static_cast<double>(triangulation.input_edges_in_wedge(h, g) + 4);
      BOOST_TEST(FG::internal::wedge_angle(triangulation, h, g).error >=
                 from.relative_error() + to.relative_error() + corners * FG::internal::input_corner_error);
    }
  BOOST_TEST(strips > 5);
}
