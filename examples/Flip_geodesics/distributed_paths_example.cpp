// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesics by several MPI processes, on one or more machines. Each process has its own triangulation. The
// process of rank 0 distributes the paths, computes some of them itself, and writes the results in order.
//
//   mpirun -n 4 distributed_paths_example PATHS RESULTS
//
// A line of PATHS has the form `MESH SOURCE TARGET`: a file and two vertices. Paths on the same mesh should be on
// consecutive lines, since a process reads a mesh whenever the mesh differs from that of the previous path. A line of
// RESULTS repeats the line of a path, followed by the length and the status of the path, or by an error message. An
// interrupted run is continued at the end of RESULTS, with any number of processes. The results do not depend on the
// number of processes.
//
// The other processes communicate only with rank 0, once for every eight paths. Rank 0 answers between two paths that
// it computes itself, so it can limit the speed of a run with many processes.

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace mpi = boost::mpi;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Lines = std::vector<std::string>;

// A mesh and its triangulation, whose flips are rolled back after each path.
class Surface
{
public:
  explicit Surface(const std::string& file)
    : m_file(file)
  {
    if(!CGAL::IO::read_polygon_mesh(file, m_mesh) || !CGAL::is_triangle_mesh(m_mesh) || m_mesh.is_empty())
      throw std::invalid_argument("the file does not contain a triangle mesh");
  }

  const std::string& file() const { return m_file; }

  FG::Curve_report path(std::size_t source, std::size_t target)
  try {
    if(std::max(source, target) >= m_mesh.number_of_vertices())
      throw std::invalid_argument("a vertex does not exist; the mesh has " +
                                  std::to_string(m_mesh.number_of_vertices()) + " vertices, numbered from 0");
    if(!m_triangulation)
      m_triangulation = std::make_unique<Triangulation>(m_mesh);
    if(!m_search)
      m_search = std::make_unique<Search>(*m_triangulation);
    FG::Edge_path_network<Triangulation> network(*m_triangulation);
    add_straightened_path(network, (*m_search)(FG::Vertex_index(source), FG::Vertex_index(target)));
    const FG::Curve_report report = shorten(network).curves.front();
    network.clear();
    m_triangulation->rollback();
    return report;
  } catch(...) {
    m_search.reset(); // both are constructed again for the next path
    m_triangulation.reset();
    throw;
  }

private:
  using Search = FG::Shortest_edge_path<Triangulation>;

  std::string m_file;
  Mesh m_mesh;
  std::unique_ptr<Triangulation> m_triangulation;
  std::unique_ptr<Search> m_search;
};

// Returns the line of a path with its result, which can be an error message.
std::string solve(const std::string& path, std::unique_ptr<Surface>& surface)
{
  std::ostringstream result;
  result << path << ": " << std::setprecision(std::numeric_limits<double>::max_digits10);
  try {
    std::istringstream line(path);
    std::string file;
    std::size_t source, target;
    if(!(line >> std::quoted(file) >> source >> target))
      throw std::invalid_argument("a line of paths must have the form MESH SOURCE TARGET");
    if(!surface || surface->file() != file)
      surface = std::make_unique<Surface>(file);
    const FG::Curve_report report = surface->path(source, target);
    result << report.length << ' ' << to_string(report.status);
  } catch(const std::exception& error) {
    result << "error: " << error.what();
  }
  std::string text = result.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// Returns the lines that are not empty.
Lines read_lines(const std::string& file)
{
  std::ifstream in(file);
  if(!in)
    throw std::invalid_argument("cannot read " + file);
  Lines lines;
  for(std::string line; std::getline(in, line);)
    if(!line.empty())
      lines.push_back(line);
  return lines;
}

// Returns the number of results that the file already contains. An incomplete last line is removed.
std::size_t count_results(const std::string& file, const Lines& paths)
{
  if(!std::filesystem::exists(file))
    return 0;
  std::size_t size = 0, count = 0;
  for(const std::string& line : read_lines(file)) {
    if(size + line.size() == std::filesystem::file_size(file))
      break;
    if(count == paths.size() || line.rfind(paths[count] + ": ", 0) != 0)
      throw std::invalid_argument(file + " contains results of other paths; remove it or choose another file");
    size += line.size() + 1;
    ++count;
  }
  std::filesystem::resize_file(file, size);
  return count;
}

// Eight paths at a time are sent to a rank. It requests the next eight before it computes those that it has received.
constexpr std::size_t PATHS_AT_ONCE = 8;
constexpr int ASK = 0, HAND_OUT = 1, RESULT = 2;
using Handful = std::pair<std::size_t, Lines>; // the index of the first path, and the lines

// Sends a message without waiting until it has been received, but waits for the previous message.
class Sender
{
public:
  Sender() = default;
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;
  ~Sender() { finish(); }

  void operator()(const mpi::communicator& world, int rank, int tag, const Handful& handful)
  {
    finish();
    m_request = world.isend(rank, tag, handful);
  }

private:
  void finish()
  {
    if(m_request)
      m_request->wait();
  }

  std::optional<mpi::request> m_request;
};

void work(const mpi::communicator& world)
{
  std::unique_ptr<Surface> surface;
  Sender send_results;
  world.send(0, ASK);
  for(Handful handful;;) {
    world.recv(0, HAND_OUT, handful);
    if(handful.second.empty())
      return;
    world.send(0, ASK);
    for(std::string& line : handful.second)
      line = solve(line, surface);
    send_results(world, 0, RESULT, handful);
  }
}

// The process of rank 0.
class Leader
{
public:
  Leader(const mpi::communicator& world, const std::string& paths, const std::string& results)
    : m_world(world)
    , m_paths(read_lines(paths))
    , m_written(count_results(results, m_paths))
    , m_next(m_written)
    , m_file(results, std::ios::app)
  {
  }

  // Returns the number of paths of this run that could not be computed.
  std::size_t operator()()
  {
    while(m_written < m_paths.size() || m_dismissed + 1 < m_world.size()) {
      while(const auto message = m_world.iprobe())
        answer(*message);
      if(m_next < m_paths.size()) {
        const std::size_t own = m_next++;
        write(own, {solve(m_paths[own], m_surface)});
      } else if(m_dismissed + 1 < m_world.size()) {
        answer(m_world.probe());
      }
    }
    return m_errors;
  }

private:
  void answer(const mpi::status& message)
  {
    if(message.tag() == RESULT) {
      Handful handful;
      m_world.recv(message.source(), RESULT, handful);
      write(handful.first, handful.second);
      return;
    }
    m_world.recv(message.source(), ASK);
    const std::size_t end = std::min(m_next + PATHS_AT_ONCE, m_paths.size());
    m_hand_out[message.source()](m_world, message.source(), HAND_OUT,
                                 {m_next, Lines(m_paths.begin() + m_next, m_paths.begin() + end)});
    m_dismissed += m_next == end;
    m_next = end;
  }

  // Results are written in the order of the paths; those that arrive too early are stored.
  void write(std::size_t first, const Lines& lines)
  {
    m_waiting[first] = lines;
    for(auto next = m_waiting.find(m_written); next != m_waiting.end(); next = m_waiting.find(m_written)) {
      for(const std::string& line : next->second) {
        m_errors += line.compare(m_paths[m_written].size(), 9, ": error: ") == 0;
        m_file << line << '\n';
        ++m_written;
      }
      m_waiting.erase(next);
    }
    if(!m_file.flush())
      throw std::runtime_error("cannot write the results");
  }

  const mpi::communicator& m_world;
  Lines m_paths;
  std::size_t m_written; // results in the file
  std::size_t m_next;    // the first path that has not been distributed
  std::ofstream m_file;
  std::map<int, Sender> m_hand_out; // by rank
  std::map<std::size_t, Lines> m_waiting;
  std::unique_ptr<Surface> m_surface;
  std::size_t m_errors = 0;
  int m_dismissed = 0; // the number of ranks that have received an empty list of paths
};

int main(int argc, char** argv)
{
  const mpi::environment environment(argc, argv);
  const mpi::communicator world;
  try {
    if(world.rank() != 0) {
      work(world);
      return EXIT_SUCCESS;
    }
    if(argc != 3)
      throw std::invalid_argument("specify two files: one with lines MESH SOURCE TARGET, and one for the results");
    const std::size_t errors = Leader(world, argv[1], argv[2])();
    if(errors > 0)
      std::cerr << errors << " of the paths failed; see " << argv[2] << '\n';
    return errors > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    mpi::environment::abort(EXIT_FAILURE); // since the other ranks wait for messages of this one
  }
}
