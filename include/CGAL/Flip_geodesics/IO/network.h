// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_NETWORK_H
#define CGAL_FLIP_GEODESICS_IO_NETWORK_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/* The hash function FNV-1a, 64 bits. */
class Fingerprint
{
public:
  void add(const void* data, std::size_t size)
  {
    const unsigned char* bytes = static_cast<const unsigned char*>(data);
    for(std::size_t i = 0; i < size; ++i)
      m_value = (m_value ^ bytes[i]) * 1099511628211u;
  }

  template <class Integer>
  void add_integer(Integer value)
  {
    unsigned char bytes[8];
    for(int i = 0; i < 8; ++i)
      bytes[i] = static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i));
    add(bytes, sizeof bytes);
  }

  void add_double(double value)
  {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value, "a double must have 64 bits");
    std::memcpy(&bits, &value, sizeof bits);
    add_integer(bits);
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 14695981039346656037u;
};

/* Returns the fingerprint of the input of a triangulation: its connectivity and edge lengths. */
template <class Triangulation>
std::uint64_t input_fingerprint(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  Fingerprint fingerprint;
  for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    fingerprint.add_integer(input.tail(h).idx());
    fingerprint.add_integer(input.is_border(h) ? Index(null_index) : input.next(h).idx());
    if(internal::is_first_side(h))
      fingerprint.add_double(triangulation.metric().weight(input, h));
  }
  return fingerprint.value();
}

/*
 * One entry of a flip log: `f` a flip, `r` a face recomputed from the input, `v` a vertex inserted into a face, `e` a
 * vertex inserted on an edge. The gap of an insertion is recorded because the location, which is rounded, does not
 * determine it: a point that divides an edge lies on that edge by definition, but beside it by its weights.
 */
struct Log_entry
{
  char kind = 'f';
  Halfedge_index halfedge = null_index;
  Index gap = 0;             // of the edge sequence of the halfedge, for an insertion
  Surface_location location; // of the inserted vertex

  bool is_insertion() const { return kind == 'v' || kind == 'e'; }

  bool operator==(const Log_entry& other) const
  {
    return kind == other.kind && halfedge == other.halfedge && gap == other.gap &&
           location.halfedge == other.location.halfedge && location.weights == other.location.weights;
  }
};

template <class Triangulation>
Log_entry log_entry(const Triangulation& triangulation, std::size_t i)
{
  const auto& record = triangulation.flip_record(i);
  if(!record.is_insertion())
    return {record.is_flip() ? 'f' : 'r', record.h, 0, {}};
  return {record.is_on_edge() ? 'e' : 'v', record.h, record.gap(),
          triangulation.location(Vertex_index(triangulation.input().number_of_vertices() + record.number))};
}

/*
 * Returns whether an input face, given by any of its halfedges, contains a location that is not a vertex, and, if
 * `is_along`, whether the location lies on the edge of the halfedge.
 */
template <class Input_mesh>
bool is_location_in_face(const Input_mesh& input, const Surface_location& location, Input_halfedge_index face,
                         bool is_along)
{
  if(kind(location) == Location_kind::VERTEX || (is_along && kind(location) != Location_kind::EDGE))
    return false;
  for(Input_halfedge_index h : {face, input.next(face), input.next(input.next(face))})
    if(kind(location) == Location_kind::FACE ? h == location.halfedge : are_of_one_edge(h, location.halfedge))
      return h == face || !is_along;
  return false;
}

/*
 * Inserts the vertex of an entry at its previous position. Returns false if its halfedge, gap and location are
 * inconsistent; a point outside the face or edge is detected when the new faces are laid out.
 */
template <class Triangulation>
bool repeat_insertion(Triangulation& triangulation, const Log_entry& entry)
{
  check_location(triangulation.input(), entry.location);
  const Edge_sequence sequence = triangulation.edge_sequence(entry.halfedge);
  if(entry.gap < 0 || entry.gap > static_cast<Index>(sequence.crossed.size()))
    return false;
  const std::size_t gap = static_cast<std::size_t>(entry.gap);
  const Input_halfedge_index face = face_of_gap(sequence, gap);
  const bool is_along = entry.kind == 'e' && sequence.along != null_index;
  if(!is_location_in_face(triangulation.input(), entry.location, face, is_along))
    return false;
  if(entry.kind == 'e')
    triangulation.split_edge(entry.halfedge, entry.location, gap, [](const auto&) {}); // the network has no curves yet
  else
    triangulation.split_face(entry.halfedge, entry.location, gap);
  return true;
}

/* Repeats the operation of an entry; returns false if that is impossible. */
template <class Triangulation>
bool repeat(Triangulation& triangulation, const Log_entry& entry)
{
  const Halfedge_index h = entry.halfedge;
  if(!h.is_valid() || h.idx() >= triangulation.number_of_halfedges() || triangulation.is_border(h))
    return false;
  if(entry.is_insertion())
    return repeat_insertion(triangulation, entry);
  if(entry.kind == 'r')
    return refresh_face(triangulation, h);
  const Halfedge_index t = Triangulation::twin(h);
  if(triangulation.is_border(t) || triangulation.next(h) == t || triangulation.next(t) == h)
    return false;
  triangulation.flip(h);
  return true;
}

/* Reads the words of a saved network, and keeps their position for error messages. */
class Network_reader
{
public:
  explicit Network_reader(const std::string& text)
    : m_in(text)
  {
    m_in.imbue(std::locale::classic());
  }

  template <class T>
  T get(const char* what)
  {
    T value{};
    if(!(m_in >> value))
      fail(what);
    ++m_count;
    return value;
  }

  Index index(const char* what) { return get<Index>(what); }

  /* Reads an edge, whose halfedges have numbers twice as large. */
  Edge_index edge()
  {
    const Index number = index("edge");
    if(number < 0 || number > (std::numeric_limits<Index>::max)() / 2)
      fail("edge");
    return Edge_index(number);
  }

  /*
   * Reads a number of items that take at least one word each, so that no memory is allocated that the text cannot fill.
   */
  std::size_t count(const char* what, std::size_t size)
  {
    const auto value = get<long long>(what);
    if(value < 0 || static_cast<unsigned long long>(value) > size)
      fail(what);
    return static_cast<std::size_t>(value);
  }

  void keyword(const char* word)
  {
    if(get<std::string>(word) != word)
      fail(word);
  }

  [[noreturn]] void fail(const char* what) const
  {
    throw_naming<File_format_error>("the saved network is corrupt: no valid ", what, " after ", Element{m_count},
                                    " words");
  }

private:
  std::istringstream m_in;
  std::size_t m_count = 0;
};

constexpr const char* network_magic = "flip_geodesics_network";
constexpr int network_version = 2;

template <class Triangulation>
void write_log(std::ostream& out, const Triangulation& triangulation)
{
  out << "log " << triangulation.log_position() << '\n';
  for(std::size_t i = 0; i < triangulation.log_position(); ++i) {
    const Log_entry entry = log_entry(triangulation, i);
    out << entry.kind << ' ' << entry.halfedge.idx();
    if(entry.is_insertion()) {
      out << ' ' << entry.gap << ' ' << entry.location.halfedge.idx();
      for(double weight : entry.location.weights)
        out << ' ' << weight;
    }
    out << '\n';
  }
}

inline void write_state(std::ostream& out, const Network_state& state)
{
  out << "curves " << state.curves.size() << ' ' << state.end_of_segment_ids << '\n';
  for(const Network_state::Curve& curve : state.curves) {
    out << (curve.is_closed ? "closed " : "open ") << curve.initial_length << ' ' << curve.segments.size() << '\n';
    for(const Network_state::Segment& s : curve.segments)
      out << s.id.idx() << ' ' << s.halfedge.idx() << ' ' << (s.is_head_fixed ? 1 : 0) << '\n';
  }
  out << "stacks " << state.bundles.size() << '\n';
  for(const Network_state::Bundle& bundle : state.bundles) {
    out << bundle.edge.idx() << ' ' << bundle.segments.size();
    for(Segment_index s : bundle.segments)
      out << ' ' << s.idx();
    out << '\n';
  }
}

/* Version 1 did not record gaps, so only networks without inserted vertices can be restored from it. */
inline void check_insertions_of_version(int version)
{
  if(version < 2)
    throw File_format_error("the saved network has version 1, which does not record on which edge or in which face a "
                            "vertex was inserted; save the network again with this version of the library");
}

inline std::vector<Log_entry> read_log(Network_reader& in, int version, std::size_t size)
{
  in.keyword("log");
  std::vector<Log_entry> log(in.count("number of log entries", size));
  for(Log_entry& entry : log) {
    entry.kind = in.get<char>("log entry");
    if(entry.kind != 'f' && entry.kind != 'r' && !entry.is_insertion())
      in.fail("log entry");
    entry.halfedge = Halfedge_index(in.index("halfedge"));
    if(entry.is_insertion()) {
      check_insertions_of_version(version);
      entry.gap = in.index("gap");
      entry.location.halfedge = Input_halfedge_index(in.index("halfedge"));
      for(double& weight : entry.location.weights)
        weight = in.get<double>("weight");
    }
  }
  return log;
}

inline Network_state read_state(Network_reader& in, std::size_t size)
{
  Network_state state;
  in.keyword("curves");
  state.curves.resize(in.count("number of curves", size));
  state.end_of_segment_ids = in.index("number of segments");
  for(Network_state::Curve& curve : state.curves) {
    const auto kind = in.get<std::string>("curve");
    if(kind != "closed" && kind != "open")
      in.fail("curve");
    curve.is_closed = kind == "closed";
    curve.initial_length = in.get<double>("length");
    curve.segments.resize(in.count("number of segments", size));
    for(Network_state::Segment& s : curve.segments) {
      s.id = Segment_index(in.index("segment"));
      s.halfedge = Halfedge_index(in.index("halfedge"));
      s.is_head_fixed = in.get<int>("mark") != 0;
    }
  }
  in.keyword("stacks");
  state.bundles.resize(in.count("number of bundles", size));
  for(Network_state::Bundle& bundle : state.bundles) {
    bundle.edge = in.edge();
    bundle.segments.resize(in.count("size of a bundle", size));
    for(Segment_index& s : bundle.segments)
      s = Segment_index(in.index("segment"));
  }
  return state;
}

template <class Triangulation>
void replay(Triangulation& triangulation, const std::vector<Log_entry>& log)
{
  const auto fail = [](std::size_t i) {
    throw_naming<File_format_error>("the saved network was made with other traits, or another version of them: entry ",
                                    Element{i}, " of its flip log cannot be replayed");
  };
  const auto is_repeated = [&](const Log_entry& entry) { // false if a logged insertion is rejected
    try {
      return repeat(triangulation, entry);
    } catch(const Invalid_location_error&) {
      return false;
    } catch(const Insertion_error&) {
      return false;
    }
  };
  for(std::size_t i = 0; i < log.size(); ++i) {
    // A flip can also recompute faces from the input, which are separate entries.
    if(triangulation.log_position() <= i && !is_repeated(log[i]))
      fail(i);
    if(triangulation.log_position() <= i || !(log_entry(triangulation, i) == log[i]))
      fail(i);
  }
  if(triangulation.log_position() != log.size())
    fail(log.size());
}

/*
 * Returns the text before its last line, which must contain the fingerprint of the text. The rest is left in the
 * stream. Any line ends are accepted.
 */
inline std::string checked_text(std::istream& in)
{
  if(!in.good())
    throw File_format_error("nothing can be read from the stream; it should contain a saved network");
  std::istream lines(in.rdbuf()); // has no exceptions of its own
  const std::string first_word = network_magic;
  std::string text, line;
  std::uint64_t expected = 0;
  bool has_end = false;
  while(!has_end && std::getline(lines, line)) {
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    has_end = line.compare(0, 4, "end ") == 0 && std::istringstream(line.substr(4)) >> expected;
    if(!has_end)
      text += line + '\n';
    if(text.compare(0, first_word.size(), first_word) != 0)
      break;
  }
  std::istringstream start(text);
  std::string magic;
  int version = 0;
  if(!(start >> magic >> version) || magic != first_word)
    throw File_format_error("the stream does not contain a saved network: it does not begin with " + first_word +
                                " and a version number",
                            {0});
  if(version < 1 || version > network_version)
    throw File_format_error("the saved network has version " + std::to_string(version) + ", but only versions 1 to " +
                                std::to_string(network_version) + " are known",
                            {1});
  if(!has_end)
    throw File_format_error("the saved network is cut off: its last line is missing");
  Fingerprint fingerprint;
  fingerprint.add(text.data(), text.size());
  if(fingerprint.value() != expected)
    throw File_format_error("the saved network has been changed: it does not agree with the checksum at its end");
  return text;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Saves a network together with its triangulation as text.
 *
 * The text contains the log of flips and insertions, the segments of the curves, and the order of overlapping segments
 * on edges, which does not follow from the curves. The input mesh itself is not written, only a fingerprint of its
 * connectivity and edge lengths.
 *
 * The format, version 2, consists of words separated by blanks. Numbers are written in decimal with all significant
 * digits, and indices are those of the library.
 *
 *     flip_geodesics_network 2
 *     input VERTICES HALFEDGES FINGERPRINT
 *     log N              then N lines: f H, the edge of H was flipped; r H, the face of H was recomputed;
 *                        v H GAP LOCATION_HALFEDGE W0 W1 W2, a vertex was inserted into the face of H, in the input
 *                        face that the edge of H enters after GAP crossings; e with the same fields, a vertex was
 *                        inserted on the edge of H
 *     curves C END       the ids of segments are less than END; then for each curve: open|closed INITIAL_LENGTH S, and
 *                        S lines: ID HALFEDGE IS_HEAD_FIXED
 *     stacks K           then K lines, one per bundle: EDGE N ID ... ID
 *     end CHECKSUM       the FNV-1a hash of all preceding lines
 *
 * Version 1 differs only in insertions: it used `v` for both kinds, without the gap. Files of version 1 can be read if
 * no vertex was inserted.
 *
 * \param out the stream, whose state indicates errors
 * \param network the network
 * \return `out`
 *
 * Complexity: linear in the sizes of the mesh and the log.
 */
template <class Network>
std::ostream& write_network(std::ostream& out, const Network& network)
{
  const auto& triangulation = network.triangulation();
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << internal::network_magic << ' ' << internal::network_version << '\n';
  text << "input " << triangulation.input().number_of_vertices() << ' ' << triangulation.input().number_of_halfedges()
       << ' ' << internal::input_fingerprint(triangulation) << '\n';
  internal::write_log(text, triangulation);
  internal::write_state(text, internal::network_state(network));
  internal::Fingerprint fingerprint;
  fingerprint.add(text.str().data(), text.str().size());
  return out << text.str() << "end " << std::to_string(fingerprint.value()) << '\n';
}

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Loads a network that was saved by `write_network()`. The triangulation of the network must have the same input and
 * the same traits as the saved triangulation. The function repeats all flips and insertions, and restores the curves.
 *
 * The result is bitwise identical to the saved network and its triangulation, including the ids of segments. A
 * subsequent call of `shorten()` therefore has the same result as for the saved network. Inserted vertices, including
 * those inserted by `refine()` and those on curves, are restored as well.
 *
 * The order of overlapping curves is restored as it was saved. If `order_overlapping_curves()` was not called before
 * the network was saved, `Edge_path_network::is_valid()` can be `false` for the restored network, as for the saved one.
 *
 * The function reads up to the end of the line with the checksum, so several networks can be read from one stream. The
 * line endings of all systems are accepted. If the function throws, the triangulation and the network are unchanged.
 *
 * \param in the stream
 * \param network an empty network in a triangulation that has not been flipped
 * \throws File_format_error if the text is not a saved network of a known version, is damaged, or was written with
 *         traits that compute differently; if its version is 1 and it contains inserted vertices; or if nothing can be
 *         read from the stream
 * \throws Input_mismatch_error if the network was saved for another mesh, or another metric
 * \throws Occupied_triangulation_error if another network has curves in the triangulation
 *
 * Complexity: linear in the size of the mesh, the number of flips and the number of segments.
 */
template <class Triangulation>
void read_network(std::istream& in, Edge_path_network<Triangulation>& network)
{
  Triangulation& triangulation = network.triangulation();
  CGAL_precondition(network.number_of_curves() == 0 && triangulation.log_position() == 0);
  internal::check_has_no_curves(triangulation, "a network cannot be restored");
  const std::string text = internal::checked_text(in);
  internal::Network_reader words(text);
  words.keyword(internal::network_magic);
  const int version = words.index("version");
  words.keyword("input");
  const Index vertices = words.index("number of vertices"), halfedges = words.index("number of halfedges");
  const auto fingerprint = words.template get<std::uint64_t>("fingerprint");
  const auto& input = triangulation.input();
  if(vertices != input.number_of_vertices() || halfedges != input.number_of_halfedges() ||
     fingerprint != internal::input_fingerprint(triangulation))
    throw Input_mismatch_error("the network was saved for another mesh, of " + std::to_string(vertices) +
                               " vertices and " + std::to_string(halfedges / 2) +
                               " edges, or for the same mesh with other edge lengths");
  const std::vector<internal::Log_entry> log = internal::read_log(words, version, text.size());
  const internal::Network_state state = internal::read_state(words, text.size());
  constexpr std::size_t usual = 1u << 24; // ids of replaced segments take memory, too
  if(state.end_of_segment_ids < 1 || static_cast<std::size_t>(state.end_of_segment_ids) > usual + 64 * text.size())
    words.fail("number of segments");
  try {
    internal::replay(triangulation, log);
    if(!internal::Internals<std::decay_t<decltype(network)>>::restore(network, state))
      words.fail("network of curves");
  } catch(...) {
    network.clear();
    triangulation.rollback(0);
    throw;
  }
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_IO_NETWORK_H
