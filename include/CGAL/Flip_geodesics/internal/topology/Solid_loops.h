// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SOLID_LOOPS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SOLID_LOOPS_H

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Linking_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Integer vectors that are part of a basis of all integer vectors, added one by one.
 *
 * A unimodular matrix U is maintained such that the k vectors times U are zero from column k on. Another vector can be
 * added if its product with U has no common divisor there.
 */
class Primitive_rows
{
public:
  using Row = std::vector<std::int64_t>;

  explicit Primitive_rows(std::size_t n)
    : m_columns(n, Numbers(n, Integer(0)))
  {
    for(std::size_t i = 0; i < n; ++i)
      m_columns[i][i] = Integer(1);
  }

  std::size_t size() const { return m_size; }

  /* Adds a vector if it is part of a basis together with the present ones; returns whether it is. */
  bool add(const Row& row)
  {
    const std::size_t n = m_columns.size();
    for(std::size_t c = m_size; c < n; ++c)
      m_columns[c].push_back(product(row, m_columns[c]));
    const std::size_t pivot = reduce(m_columns, m_size, n);
    const bool is_primitive = pivot < n && absolute(m_columns[pivot][n]) == Integer(1);
    for(std::size_t c = m_size; c < n; ++c)
      m_columns[c].pop_back();
    if(is_primitive)
      m_columns[m_size++].swap(m_columns[pivot]);
    return is_primitive;
  }

  /* Returns combinations of rows that, together with the present vectors, generate the same as all rows.
   * \pre the vectors are combinations of the rows, which have a basis that is part of a basis of all vectors */
  std::vector<Row> completed_by(const std::vector<Row>& rows) const
  {
    const std::size_t size_of_rest = m_columns.size() - m_size;
    std::vector<Numbers> left; // the product of each row with the columns from k on, and the row
    for(const Row& row : rows) {
      left.emplace_back();
      for(std::size_t c = m_size; c < m_columns.size(); ++c)
        left.back().push_back(product(row, m_columns[c]));
      left.back().insert(left.back().end(), row.begin(), row.end());
    }
    std::vector<Row> result;
    for(std::size_t c = 0; c < size_of_rest; ++c) {
      const std::size_t pivot = reduce(left, 0, c);
      if(pivot == left.size())
        continue;
      result.emplace_back();
      for(std::size_t i = size_of_rest; i < left[pivot].size(); ++i)
        result.back().push_back(static_cast<std::int64_t>(left[pivot][i]));
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(pivot));
    }
    return result;
  }

private:
  using Numbers = std::vector<Integer>;

  static Integer product(const Row& row, const Numbers& column)
  {
    Integer result(0);
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0 && column[i].sign() != 0)
        result += Integer(row[i]) * column[i];
    return result;
  }

  // Euclid's algorithm for the vectors from `first` on, by their i-th entries: all of these become zero but one, that
  // of the returned vector. Returns the number of vectors if all are zero.
  static std::size_t reduce(std::vector<Numbers>& vectors, std::size_t first, std::size_t i)
  {
    const auto is_smaller = [i](const Numbers& a, const Numbers& b) {
      return a[i].sign() != 0 && (b[i].sign() == 0 || absolute(a[i]) < absolute(b[i]));
    };
    const auto begin = vectors.begin() + static_cast<std::ptrdiff_t>(first);
    for(bool is_one_left = false;;) {
      const auto pivot = std::min_element(begin, vectors.end(), is_smaller);
      if(pivot == vectors.end() || (*pivot)[i].sign() == 0)
        return vectors.size();
      if(is_one_left)
        return static_cast<std::size_t>(pivot - vectors.begin());
      is_one_left = true;
      for(auto v = begin; v != vectors.end(); ++v) {
        if(v == pivot || (*v)[i].sign() == 0)
          continue;
        const Integer quotient = (*v)[i] / (*pivot)[i];
        for(std::size_t k = 0; k < v->size(); ++k)
          (*v)[k] -= quotient * (*pivot)[k];
        is_one_left = is_one_left && (*v)[i].sign() == 0;
      }
    }
  }

  std::vector<Numbers> m_columns; // of the matrix
  std::size_t m_size = 0;         // of the present vectors
};

/* Sums over the edges of a loop, modulo 2^64, that distinguish classes. The loop does not bound on the surface if its
 * name is not zero, and bounds on a side in space if its remainder on that side is zero. */
struct Class_sums
{
  std::uint64_t name = 0;
  std::array<std::uint64_t, 2> remainders = {0, 0}; // behind the surface and in front of it

  Class_sums& add(const Class_sums& other, bool is_backwards)
  {
    const auto add_to = [is_backwards](std::uint64_t& a, std::uint64_t b) { a += is_backwards ? -b : b; };
    add_to(name, other.name);
    for(std::size_t side : {0, 1})
      add_to(remainders[side], other.remainders[side]);
    return *this;
  }

  bool bounds(std::size_t side) const { return name != 0 && remainders[side] == 0; }
};

/*
 * The shortest loops through a vertex that consist of a shortest path, an edge and a shortest path back, and bound
 * behind the surface or in front of it: one of either kind, among the wanted ones. The search ends where longer ones
 * begin, or when many vertices were reached.
 */
template <class Triangulation>
class Bounding_loop_search
{
public:
  using Sums = Indexed_by<Edge_index, std::vector<Class_sums>>;
  using Loop = std::vector<Halfedge_index>;

  /* `sums` are those of the first sides of edges; searches can be interrupted. */
  Bounding_loop_search(const Triangulation& triangulation, const Sums& sums, Interruption* interruption)
    : m_sums(sums)
    , m_search(triangulation, interruption)
  {
  }

  /* Returns the loops for which `is_wanted(side, sums)` holds, empty if none was found among `most` vertices, without
   * the common part of their two paths. \throws Interrupted */
  template <class IsWanted>
  std::array<Loop, 2> operator()(Vertex_index root, std::size_t most, const IsWanted& is_wanted)
  {
    Policy<IsWanted> policy(m_search, m_sums, most, is_wanted);
    m_search.run(root, Class_sums(), policy);
    std::array<Loop, 2> result;
    for(std::size_t side : {0, 1})
      if(policy.closing(side) != null_index)
        result[side] = m_search.loop(policy.closing(side)).cycle();
    return result;
  }

private:
  using Search = Loop_search<Triangulation, Class_sums>;

  // Stores the edges that close the best loops of either kind.
  template <class IsWanted>
  class Policy : public Search::template Policy<Policy<IsWanted>>
  {
    using Base = typename Search::template Policy<Policy<IsWanted>>;

  public:
    Policy(Search& search, const Sums& sums, std::size_t most, const IsWanted& is_wanted)
      : Base(search)
      , m_sums(sums)
      , m_most(most)
      , m_is_wanted(is_wanted)
    {
      m_lengths.fill(std::numeric_limits<double>::infinity());
      m_closing.fill(null_index);
    }

    Input_halfedge_index closing(std::size_t side) const { return m_closing[side]; }

    template <class Queue>
    bool is_finished(Queue& queue) const
    {
      return m_number_of_reached >= m_most || !(2 * queue.priority() < (std::max)(m_lengths[0], m_lengths[1]));
    }

    Class_sums extended(Class_sums path, Input_halfedge_index h) const
    {
      return path.add(m_sums[edge_of(as_intrinsic(h))], !is_first_side(h));
    }

    void reach(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w, bool is_first)
    {
      Base::reach(origin, h, w, is_first);
      m_number_of_reached += is_first ? 1 : 0;
    }

    void meet(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w)
    {
      const double length = this->length_of_loop(origin, h, w);
      const Class_sums sums = this->class_over(origin, h).add(this->class_of_path(w), true);
      for(std::size_t side : {0, 1})
        if(sums.bounds(side) && length < m_lengths[side] && m_is_wanted(side, sums)) {
          m_lengths[side] = length;
          m_closing[side] = h;
        }
    }

  private:
    const Sums& m_sums;
    std::size_t m_most, m_number_of_reached = 1; // the root
    const IsWanted& m_is_wanted;
    std::array<double, 2> m_lengths;               // of the best loops
    std::array<Input_halfedge_index, 2> m_closing; // their edges that are on no path
  };

  const Sums& m_sums;
  Search m_search;
};

/*
 * Loops of a closed surface in space that bound inside of it, and loops that bound outside: a basis of either kind.
 *
 * Whether a class is in one of the two kernels is tested by a number modulo 2^64, that of the class times a projector
 * and a pseudorandom vector, and then verified. A search therefore requires only one number per edge. There are many
 * loops to choose from: those of all edges outside the tree of shortest paths, and the shortest ones through the
 * vertices at which the generators' loops turn back, which are far from the base point.
 */
template <class Triangulation>
class Solid_loops
{
  using Row = Primitive_rows::Row;
  using Loop = std::vector<Halfedge_index>;

public:
  /* \throws Interrupted */
  explicit Solid_loops(const Triangulation& triangulation, Interruption* interruption = nullptr)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_forest(checked_input(), std::vector<Vertex_index>(), weight(), interruption)
    , m_cotree(input(), m_forest, Borders::CLOSED_BY_ONE_FACE, weight(), interruption)
    , m_words(input(), m_forest, m_cotree, interruption)
    , m_rooted(input(), m_cotree)
    , m_places(input().number_of_vertices(), [this](Vertex_index v) { return place(v); })
  {
    list_edges();
    Bounding_loop_search<Triangulation> search(triangulation, m_sums, interruption);
    for(std::size_t first = 0, last = 0; first < number_of_generators(); first = last) {
      while(last < number_of_generators() && component(last) == component(first))
        ++last;
      find(first, last, search);
    }
  }

  const std::vector<Loop>& inside() const { return m_inside; }
  const std::vector<Loop>& outside() const { return m_outside; }

private:
  using Rooted = typename Linking_matrix<Triangulation>::Rooted;
  using Places = std::array<Weighted_place, 3>;

  // A loop whose class seems to bound: that of an edge outside the forest, or any other chain.
  struct Candidate
  {
    double length;
    Input_halfedge_index halfedge;
    Loop loop;

    friend bool operator<(const Candidate& a, const Candidate& b)
    {
      return std::tie(a.length, a.halfedge) < std::tie(b.length, b.halfedge);
    }
  };

  // Of loops of the same or the opposite class, the shortest is kept.
  using Candidates = std::map<std::uint64_t, Candidate>;

  struct Basis
  {
    Primitive_rows taken;
    std::vector<Row> classes;
    std::vector<Loop> loops;
  };

  const auto& input() const { return m_triangulation.input(); }
  std::size_t number_of_generators() const { return m_cotree.generators().size(); }
  std::size_t component(std::size_t i) const { return static_cast<std::size_t>(m_cotree.generators()[i].component); }

  Metric_weight<Triangulation> weight() const { return Metric_weight<Triangulation>{m_triangulation}; }

  const auto& checked_input() const
  {
    check_surface(input());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input().number_of_halfedges()))
      if(input().is_border(h)) {
        const Vertex_index v = input().tail(h), w = input().tail(twin_index(h));
        throw_naming<Invalid_mesh_error>("the surface has a border edge between vertices ", v, " and ", w,
                                         ", so it does not bound a solid");
      }
    return input();
  }

  Places_in_space::Coordinates place(Vertex_index v) const
  {
    decltype(auto) p = m_triangulation.metric().point(input(), v);
    const Places_in_space::Coordinates result = {imported_number(p.x()), imported_number(p.y()),
                                                 imported_number(p.z())};
    for(double x : result)
      if(!(std::abs(x) < greatest_length))
        throw_naming<Invalid_coordinate_error>("a coordinate of vertex ", v, " is not a number between -1e70 and 1e70");
    return result;
  }

  // Collects the halfedges outside the forest, by component.
  void list_edges()
  {
    m_edges.resize(m_forest.roots().size());
    m_sums.resize(static_cast<std::size_t>(input().number_of_halfedges() / 2));
    for(Edge_index e : descriptors<Edge_index>(input().number_of_halfedges() / 2)) {
      const Input_halfedge_index h = as_input(first_side(e));
      if(!m_forest.contains(input(), h))
        m_edges[static_cast<std::size_t>(m_forest.component(input().tail(h)))].push_back(h);
    }
  }

  // In one component, with the generators `first` to `last`.
  void find(std::size_t first, std::size_t last, Bounding_loop_search<Triangulation>& search)
  {
    throw_if_interrupted_before_part(m_interruption);
    m_first = first;
    m_size = last - first;
    const Linking_matrix<Triangulation> matrix(m_triangulation, m_forest, m_cotree, m_rooted, m_places, first, last,
                                               m_interruption);
    // rows that generate the classes that bound behind the surface, against its normals, and in front of it
    std::array<std::vector<Row>, 2> rows = {matrix.rows(), matrix.rows()};
    for(std::size_t i = 0; i < m_size; ++i)
      for(std::size_t j = 0; j < m_size; ++j)
        rows[0][i][j] = (i == j ? 1 : 0) - rows[0][i][j];
    throw_if_interrupted_before_part(m_interruption);
    set_sums(rows);
    std::array<Candidates, 2> candidates = loops_of_edges();
    std::array<Basis, 2> bases = {Basis{Primitive_rows(m_size), {}, {}}, Basis{Primitive_rows(m_size), {}, {}}};
    constexpr std::size_t most_rounds = 16;
    for(std::size_t round = 0; round < most_rounds && !is_complete(bases); ++round) {
      add_near_loops(search, round, candidates);
      for(std::size_t side : {0, 1})
        bases[side] = basis_of(candidates[side], rows[1 - side]);
    }
    const std::size_t inner = faces_outwards(component(first)) ? 0 : 1;
    append_basis(bases[inner], rows[inner], m_inside);
    append_basis(bases[1 - inner], rows[1 - inner], m_outside);
  }

  // A class bounds on a side if its product with the rows of the other side is zero.
  void set_sums(const std::array<std::vector<Row>, 2>& rows)
  {
    std::vector<Class_sums> of_generators(m_size);
    for(std::size_t i = 0; i < m_size; ++i) {
      of_generators[i].name = scrambled(i);
      for(std::size_t side : {0, 1})
        for(std::size_t j = 0; j < m_size; ++j)
          of_generators[i].remainders[side] += static_cast<std::uint64_t>(rows[1 - side][i][j]) * scrambled(j);
    }
    for(Input_halfedge_index h : m_edges[component(m_first)])
      m_words.for_each_letter(h, [&](Letter letter) {
        m_sums[edge_of(as_intrinsic(h))].add(of_generators[static_cast<std::size_t>(letter / 2) - m_first],
                                             letter % 2 == 1);
      });
  }

  std::array<Candidates, 2> loops_of_edges() const
  {
    std::array<Candidates, 2> result;
    for(Input_halfedge_index h : m_edges[component(m_first)]) {
      throw_if_interrupted(m_interruption);
      for(std::size_t side : {0, 1})
        if(const Class_sums& sums = m_sums[edge_of(as_intrinsic(h))]; sums.bounds(side))
          keep({length_of(m_forest.loop(input(), h).cycle()), h, {}}, sums, result[side]);
    }
    return result;
  }

  // Adds the shortest loops through a vertex of each generator's loop: in the first round those of any class through
  // the vertex at which it turns back, then those of new classes through other vertices. All searches of a round
  // together take the time of a few searches of the whole component.
  void add_near_loops(Bounding_loop_search<Triangulation>& search, std::size_t round,
                      std::array<Candidates, 2>& candidates) const
  {
    const std::size_t most = 1000 + 4 * m_edges[component(m_first)].size() / m_size;
    for(std::size_t i = 0; i < m_size; ++i) {
      throw_if_interrupted_before_part(m_interruption);
      const Input_halfedge_index h = m_cotree.generators()[m_first + i].halfedge;
      const Loop cycle = m_forest.loop(input(), h).cycle();
      const Vertex_index root = round == 0 ? input().tail(h) : input().tail(as_input(cycle[7 * round % cycle.size()]));
      const std::array<Loop, 2> loops = search(root, most, [&](std::size_t side, const Class_sums& sums) {
        return round == 0 || candidates[side].count((std::min)(sums.name, -sums.name)) == 0;
      });
      for(std::size_t side : {0, 1})
        if(!loops[side].empty()) {
          Class_sums sums;
          for(Halfedge_index g : loops[side])
            sums.add(m_sums[edge_of(g)], !is_first_side(g));
          keep({length_of(loops[side]), h, loops[side]}, sums, candidates[side]);
        }
    }
  }

  static void keep(const Candidate& candidate, const Class_sums& sums, Candidates& by_class)
  {
    const auto [found, is_new] = by_class.emplace((std::min)(sums.name, -sums.name), candidate);
    if(!is_new && candidate < found->second)
      found->second = candidate;
  }

  // Returns whether the volume is positive, with faces counterclockwise.
  bool faces_outwards(std::size_t component) const
  {
    double sum = 0, off = 0, largest = 0;
    for_each_face(component, [&](const Places& corners) {
      const auto [volume, error] = m_places.volume(corners);
      sum += volume;
      off += error;
      largest = (std::max)(largest, std::abs(sum));
    });
    off += rounding_errors(static_cast<double>(input().number_of_halfedges())) * largest;
    if(std::abs(sum) > 2 * off)
      return sum > 0;
    Integer exact(0);
    for_each_face(component, [&](const Places& corners) { exact += m_places.exact_volume(corners); });
    if(exact.sign() == 0)
      throw_naming<Invalid_mesh_error>("the component of vertex ", m_forest.roots()[component],
                                       " does not enclose a volume");
    return exact.sign() > 0;
  }

  template <class Use>
  void for_each_face(std::size_t component, const Use& use) const
  {
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input().number_of_halfedges()))
      if(m_rooted.face(h) == h && m_forest.component(input().tail(h)) == static_cast<Index>(component))
        use({Weighted_place::at_vertex(input().tail(h)), Weighted_place::at_vertex(input().tail(twin_index(h))),
             Weighted_place::at_vertex(input().tail(input().previous(h)))});
  }

  // The shortest candidates that are part of a basis, of classes whose products with `others` are zero.
  Basis basis_of(const Candidates& candidates, const std::vector<Row>& others) const
  {
    std::vector<const Candidate*> sorted;
    for(const auto& [name, candidate] : candidates)
      sorted.push_back(&candidate);
    std::sort(sorted.begin(), sorted.end(), [](const Candidate* a, const Candidate* b) { return *a < *b; });
    Basis result = {Primitive_rows(m_size), {}, {}};
    for(const Candidate* candidate : sorted) {
      if(2 * result.taken.size() == m_size)
        break;
      throw_if_interrupted(m_interruption);
      const Loop loop = candidate->loop.empty() ? m_forest.loop(input(), candidate->halfedge).cycle() : candidate->loop;
      const Row row = class_of(loop);
      if(!is_zero(row, others) || !result.taken.add(row))
        continue;
      result.classes.push_back(row);
      result.loops.push_back(loop);
    }
    return result;
  }

  bool is_complete(const std::array<Basis, 2>& bases) const
  {
    return 2 * bases[0].taken.size() == m_size && 2 * bases[1].taken.size() == m_size;
  }

  // Completes it, if necessary, to a basis of all classes that `rows` generate.
  void append_basis(const Basis& basis, const std::vector<Row>& rows, std::vector<Loop>& loops) const
  {
    loops.insert(loops.end(), basis.loops.begin(), basis.loops.end());
    if(2 * basis.taken.size() == m_size)
      return;
    std::vector<Row> missing = basis.taken.completed_by(rows);
    for(std::size_t i = 0; i < missing.size(); ++i) {
      shorten(missing, i, basis.classes);
      loops.push_back(loop_of(missing[i]));
    }
  }

  double length_of(const Loop& loop) const
  {
    double result = 0;
    for(Halfedge_index h : loop)
      result += weight()(as_input(h));
    return result;
  }

  Row class_of(const Loop& loop) const
  {
    Row result(m_size, 0);
    for(Halfedge_index h : loop)
      m_words.for_each_letter(as_input(h), [&](Letter letter) {
        result[static_cast<std::size_t>(letter / 2) - m_first] += letter % 2 == 0 ? 1 : -1;
      });
    return result;
  }

  static bool is_zero(const Row& row, const std::vector<Row>& matrix)
  {
    Row product(row.size(), 0);
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0)
        for(std::size_t j = 0; j < row.size(); ++j)
          product[j] += row[i] * matrix[i][j];
    return std::all_of(product.begin(), product.end(), [](std::int64_t x) { return x == 0; });
  }

  // Adds other classes to a class as long as this shortens the sum of its loops.
  void shorten(std::vector<Row>& rows, std::size_t i, const std::vector<Row>& classes) const
  {
    const auto is_improved_by = [&](const Row& other) {
      for(int sign : {1, -1}) {
        Row sum = rows[i];
        for(std::size_t k = 0; k < m_size; ++k)
          sum[k] += sign * other[k];
        if(length_of(sum) < length_of(rows[i])) {
          rows[i] = std::move(sum);
          return true;
        }
      }
      return false;
    };
    const auto is_improved_by_row = [&](const Row& row) { return &row != &rows[i] && is_improved_by(row); };
    while(std::any_of(classes.begin(), classes.end(), is_improved_by) ||
          std::any_of(rows.begin(), rows.end(), is_improved_by_row))
    {
    }
  }

  double length_of(const Row& row) const
  {
    double result = 0;
    for(std::size_t i = 0; i < m_size; ++i)
      result += std::abs(static_cast<double>(row[i])) * m_cotree.generators()[m_first + i].length;
    return result;
  }

  // The concatenated loops of the generators, without parts traversed back and forth.
  Loop loop_of(const Row& row) const
  {
    Loop result;
    const auto pass = [&result](Halfedge_index h) {
      if(!result.empty() && result.back() == twin_index(h))
        result.pop_back();
      else
        result.push_back(h);
    };
    for(std::size_t i = 0; i < m_size; ++i) {
      const Loop loop = m_forest.loop(input(), m_cotree.generators()[m_first + i].halfedge).whole();
      for(std::int64_t times = std::abs(row[i]); times > 0; --times)
        if(row[i] > 0)
          std::for_each(loop.begin(), loop.end(), pass);
        else
          std::for_each(loop.rbegin(), loop.rend(), [&](Halfedge_index h) { pass(twin_index(h)); });
    }
    std::size_t common = 0;
    while(2 * (common + 1) < result.size() && result[common] == twin_index(result[result.size() - 1 - common]))
      ++common;
    const auto ends = static_cast<std::ptrdiff_t>(common);
    return {result.begin() + ends, result.end() - ends};
  }

  const Triangulation& m_triangulation;
  Interruption* m_interruption; // null if it cannot be interrupted
  Edge_forest m_forest;
  Cotree m_cotree;
  Generator_words m_words;
  Rooted m_rooted;
  Places_in_space m_places;
  std::vector<std::vector<Input_halfedge_index>> m_edges;    // outside the forest, by component
  typename Bounding_loop_search<Triangulation>::Sums m_sums; // zero on the forest
  std::size_t m_first = 0, m_size = 0;                       // of the generators of the current component
  std::vector<Loop> m_inside, m_outside;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SOLID_LOOPS_H
