// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VANISHING_PROOF_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VANISHING_PROOF_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/Root_base.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Proves that the product of some chains is a real number, the roots taken for variables with known squares: that
 * is, that each coefficient of the imaginary part, a polynomial that is linear in each root, is zero. There are 2^r
 * coefficients, but the vectors that arise as coefficients of the state, the tensor product of the chains' gates, span
 * a space of small dimension: a basis is carried through the faces [Raz, Shpilka, Deterministic polynomial identity
 * testing in non-commutative models]. A root is in the state only from its first face to its last; faces of different
 * chains may be taken in any order, so that roots that congruent faces share, as those of symmetric strips, are in it
 * for a short time only.
 *
 * All is done modulo as many primes as it takes for their product to exceed the coefficients, which are integers; most
 * polynomials that are not zero are found out by the first one.
 *
 * Sound, not complete: roots are not seen to be products of others, and what would take long is given up.
 */
class Vanishing_proof
{
public:
  Vanishing_proof(const std::vector<Unfolding_chain>& chains, const Root_base& base)
  {
    for(const Unfolding_chain& chain : chains)
      add(chain, base);
    plan();
  }

  bool operator()()
  {
    if(!m_is_feasible)
      return false;
    std::size_t primes = m_bits / digits + 1;
    for(Residue p = (Residue(1) << (digits + 1)) - 1; primes > 0; p -= 2) {
      if(!is_prime(p))
        continue;
      if(!vanishes_modulo(p, most_work / primes))
        return false;
      m_work = 0;
      --primes;
    }
    return true;
  }

private:
  using Residue = std::uint64_t;

  static constexpr std::size_t none = static_cast<std::size_t>(-1), digits = 30;
  static constexpr std::size_t most_open = 6;
  static constexpr std::uint64_t most_work = std::uint64_t(1) << 32; // multiplications: some ten seconds

  /* number + i root_factor variable */
  struct Entry
  {
    Integer number = 0, root_factor = 0;
  };

  /* The map of (right, left) to (right, left); a corner has but the first entry. */
  struct Step
  {
    std::array<std::array<Entry, 2>, 2> matrix;
    std::size_t variable;
  };

  struct Sequence
  {
    std::vector<Step> steps;
    std::size_t head;
    std::size_t bit; // of the index of a state's entry: set for the left end
    bool is_conjugate;
  };

  /* A step in its place, and the open variables, bits of the index, that it needs, opens and closes. */
  struct Operation
  {
    Step step;
    std::size_t bit, variable_bit;
    bool opens, closes;
  };

  /* A step modulo a prime; roots also times the square of the variable. */
  struct Residues
  {
    struct Entry
    {
      Residue number, root_factor, squared_factor;
    };

    std::array<std::array<Entry, 2>, 2> matrix;
  };

  /* A state: complex numbers, pairs of residues, by gate ends, the low bits of the index, and open variables. */
  using Vector = std::vector<Residue>;

  void add(const Unfolding_chain& chain, const Root_base& base)
  {
    if(chain.steps.empty())
      return;
    if(chain.steps.front().kind == Unfolding_step::Kind::CORNER) {
      for(const Unfolding_step& step : chain.steps) // in any order
        m_sequences.push_back({{converted(step, chain, base)}, 0, 0, chain.is_conjugate});
      return;
    }
    Sequence sequence = {{}, 0, std::size_t(1) << m_slots++, chain.is_conjugate};
    for(const Unfolding_step& step : chain.steps)
      sequence.steps.push_back(converted(step, chain, base));
    m_read |= chain.reads_left ? sequence.bit : 0;
    m_sequences.push_back(std::move(sequence));
  }

  Step converted(const Unfolding_step& step, const Unfolding_chain& chain, const Root_base& base)
  {
    const Root_base::Root& root = base.root(step.squared_root());
    const Integer factor = chain.is_conjugate ? Integer(-root.factor) : root.factor;
    Step result = {matrix(step, chain), none};
    for(auto& row : result.matrix)
      for(Entry& entry : row)
        entry.root_factor *= factor;
    if(root.factor == 0 || root.generators.empty())
      return result;
    result.variable = static_cast<std::size_t>(std::find(m_variables.begin(), m_variables.end(), root.generators) -
                                               m_variables.begin());
    if(result.variable == m_variables.size()) {
      m_variables.push_back(root.generators);
      m_squares.push_back(base.product(root.generators));
      m_uses.push_back(0);
    }
    ++m_uses[result.variable];
    return result;
  }

  // With coefficients of the root itself.
  static std::array<std::array<Entry, 2>, 2> matrix(const Unfolding_step& step, const Unfolding_chain& chain)
  {
    const Integer l = step.squared_length(), dot = step.dot();
    const auto entry = [](const Side_combination& c) { return Entry{c.number, c.root_coefficient}; };
    const Entry zero, kept = {l, 0}, apex_of_right = {l + dot, 1}, apex_of_left = {-dot, -1};
    const std::array<Entry, 2> nothing = {zero, zero}, apex = {apex_of_right, apex_of_left};
    switch(step.kind) {
    case Unfolding_step::Kind::START:
      return {{{kept, zero}, {apex_of_right, zero}}};
    case Unfolding_step::Kind::START_INSIDE:
      return {{{entry(chain.right), zero}, {entry(chain.left), zero}}};
    case Unfolding_step::Kind::NEW_LEFT:
      return {{{kept, zero}, apex}};
    case Unfolding_step::Kind::NEW_RIGHT:
      return {{apex, {zero, kept}}};
    case Unfolding_step::Kind::POINT: {
      const auto& w = chain.weights;
      const Entry of_right = {w[1] * l + w[2] * (l + dot), w[2]}, of_left = {w[0] * l - w[2] * dot, -w[2]};
      return {{{of_right, of_left}, nothing}};
    }
    case Unfolding_step::Kind::CORNER:
      return {{{Entry{dot, 1}, zero}, nothing}};
    }
    return {};
  }

  // ---------------------------------------------------------------- the order of steps

  void plan()
  {
    std::vector<std::size_t> open;
    for(Sequence* next = choose(open); next != nullptr; next = choose(open)) {
      const Step& step = next->steps[next->head++];
      Operation operation = {step, next->bit, 0, false, false};
      if(step.variable != none) {
        operation.opens = position(open, step.variable) == open.size();
        if(operation.opens)
          open.push_back(step.variable);
        const std::size_t at = position(open, step.variable);
        operation.variable_bit = std::size_t(1) << (m_slots + at);
        operation.closes = --m_uses[step.variable] == 0;
        m_is_feasible = m_is_feasible && open.size() <= most_open;
        if(operation.closes)
          open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      }
      m_bits += bits_of_growth(step);
      m_operations.push_back(std::move(operation));
    }
  }

  // The sequence whose next step costs least: one without a new variable, or else with a variable that closes soon.
  Sequence* choose(const std::vector<std::size_t>& open)
  {
    Sequence* best = nullptr;
    std::size_t least = 0;
    for(Sequence& s : m_sequences) {
      if(s.head == s.steps.size())
        continue;
      const std::size_t variable = s.steps[s.head].variable;
      if(variable == none || position(open, variable) < open.size())
        return &s;
      const std::size_t cost = steps_to_close(variable);
      if(best == nullptr || cost < least) {
        best = &s;
        least = cost;
      }
    }
    return best;
  }

  std::size_t steps_to_close(std::size_t variable) const
  {
    std::size_t result = 0;
    for(const Sequence& s : m_sequences)
      for(std::size_t i = s.steps.size(); i > s.head; --i)
        if(s.steps[i - 1].variable == variable) {
          result += i - s.head;
          break;
        }
    return result;
  }

  static std::size_t position(const std::vector<std::size_t>& open, std::size_t variable)
  {
    return static_cast<std::size_t>(std::find(open.begin(), open.end(), variable) - open.begin());
  }

  // By how much a step lengthens the sum of the absolute values of all coefficients, at most.
  std::size_t bits_of_growth(const Step& step) const
  {
    const Integer square = step.variable == none ? Integer(1) : m_squares[step.variable];
    Integer sum = 1;
    for(const auto& row : step.matrix)
      for(const Entry& entry : row)
        sum += absolute(entry.number) + absolute(entry.root_factor) * square;
    return sum.highest_bit() + 1;
  }

  // ---------------------------------------------------------------- modulo a prime

  // For odd numbers below 4759123141 these bases tell [Jaeschke, On Strong Pseudoprimes to Several Bases].
  static bool is_prime(Residue n)
  {
    for(Residue base : {2, 7, 61})
      if(!is_strong_probable_prime(n, base))
        return false;
    return true;
  }

  static bool is_strong_probable_prime(Residue n, Residue base)
  {
    Residue odd = n - 1;
    while(odd % 2 == 0)
      odd /= 2;
    Residue x = power(base, odd, n);
    if(x == 1)
      return true;
    for(; odd < n - 1; odd *= 2, x = x * x % n)
      if(x == n - 1)
        return true;
    return false;
  }

  // Gives up after so many multiplications.
  bool vanishes_modulo(Residue p, std::uint64_t most_work_now)
  {
    m_p = p;
    m_vectors = {Vector(std::size_t(2) << m_slots, 0)};
    m_vectors[0][0] = 1;
    for(const Operation& operation : m_operations) {
      if(operation.opens)
        for(Vector& v : m_vectors)
          v.resize(2 * v.size(), 0);
      const Residues residues = residues_of(operation.step);
      for(Vector& v : m_vectors)
        v = applied(operation, residues, v);
      if(operation.closes)
        close(operation.variable_bit);
      if(m_work > most_work_now)
        return false;
    }
    const auto is_real = [this](const Vector& v) { return v[2 * m_read + 1] == 0; };
    return std::all_of(m_vectors.begin(), m_vectors.end(), is_real);
  }

  Residues residues_of(const Step& step) const
  {
    const Residue square = step.variable == none ? 1 : m_squares[step.variable].residue(m_p);
    Residues result;
    for(int i = 0; i < 2; ++i)
      for(int k = 0; k < 2; ++k) {
        const Residue factor = step.matrix[i][k].root_factor.residue(m_p);
        result.matrix[i][k] = {step.matrix[i][k].number.residue(m_p), factor, factor * square % m_p};
      }
    return result;
  }

  Vector applied(const Operation& operation, const Residues& r, const Vector& v)
  {
    m_work += 8 * v.size();
    Vector result(v.size(), 0);
    for(std::size_t i = 0; i < v.size() / 2; ++i)
      if(operation.bit == 0) {
        add_product(r.matrix[0][0], operation.variable_bit, v, i, i, result);
      } else if((i & operation.bit) == 0) {
        const std::size_t ends[] = {i, i | operation.bit};
        for(int to = 0; to < 2; ++to)
          for(int from = 0; from < 2; ++from)
            add_product(r.matrix[to][from], operation.variable_bit, v, ends[from], ends[to], result);
      }
    for(Residue& x : result)
      x %= m_p;
    return result;
  }

  // Adds an entry of a step times entry `from` of v to entry `to` of the result; the root moves it on to another one.
  // So each entry becomes the sum of four products at most, which is below 2^64.
  void add_product(const Residues::Entry& entry, std::size_t variable_bit, const Vector& v, std::size_t from,
                   std::size_t to, Vector& result) const
  {
    const Residue re = v[2 * from], im = v[2 * from + 1];
    result[2 * to] += entry.number * re;
    result[2 * to + 1] += entry.number * im;
    const Residue root = (from & variable_bit) != 0 ? entry.squared_factor : entry.root_factor;
    if(root == 0)
      return;
    const std::size_t moved = 2 * (to ^ variable_bit);
    result[moved] += root * (m_p - im);
    result[moved + 1] += root * re;
  }

  // Splits each vector in its coefficients of 1 and of the variable, and keeps a basis of what they span: no vector, if
  // the state is zero.
  void close(std::size_t variable_bit)
  {
    const std::size_t b = 2 * variable_bit;
    std::vector<Vector> halves;
    for(const Vector& v : m_vectors)
      for(std::size_t offset : {std::size_t(0), b}) {
        Vector half(v.size() / 2);
        for(std::size_t i = 0; i < half.size(); ++i)
          half[i] = v[(i & (b - 1)) | ((i & ~(b - 1)) << 1) | offset];
        halves.push_back(std::move(half));
      }
    m_vectors.clear();
    m_pivots.clear();
    for(Vector& half : halves)
      add_to_basis(std::move(half));
  }

  // Each vector of the basis has a one where the later ones have zeros.
  void add_to_basis(Vector v)
  {
    for(std::size_t k = 0; k < m_vectors.size(); ++k) {
      const Residue share = m_p - v[m_pivots[k]];
      if(share == m_p)
        continue;
      m_work += v.size();
      for(std::size_t i = 0; i < v.size(); ++i)
        v[i] = (v[i] + share * m_vectors[k][i]) % m_p;
    }
    const auto pivot = std::find_if(v.begin(), v.end(), [](Residue r) { return r != 0; });
    if(pivot == v.end())
      return;
    m_pivots.push_back(static_cast<std::size_t>(pivot - v.begin()));
    const Residue inverse = power(*pivot, m_p - 2, m_p);
    for(Residue& r : v)
      r = r * inverse % m_p;
    m_vectors.push_back(std::move(v));
  }

  static Residue power(Residue base, Residue exponent, Residue modulus)
  {
    Residue result = 1;
    for(; exponent > 0; exponent /= 2, base = base * base % modulus)
      if(exponent % 2 == 1)
        result = result * base % modulus;
    return result;
  }

  std::vector<Sequence> m_sequences;
  std::size_t m_slots = 0; // chains with gates
  std::size_t m_read = 0;  // the index of the product in the final state
  std::vector<std::vector<std::size_t>> m_variables;
  std::vector<Integer> m_squares;  // of the variables
  std::vector<std::size_t> m_uses; // still to come
  bool m_is_feasible = true;
  std::size_t m_bits = 1; // of the coefficients, at most
  std::vector<Operation> m_operations;

  Residue m_p = 0;
  std::vector<Vector> m_vectors;
  std::vector<std::size_t> m_pivots;
  std::uint64_t m_work = 0; // modulo one prime
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VANISHING_PROOF_H
