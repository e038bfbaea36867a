// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_CURVE_RUNNER_H
#define CGAL_FLIP_GEODESICS_PROGRAM_CURVE_RUNNER_H

#include "messages.h"
#include "run/computations.h"
#include "run/curve_engine.h"
#include "run/engine_parts.h"
#include "run/progress.h"
#include "run/shortening_recorder.h"
#include "run/surface_request.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Computes the curves: each by itself on the same triangulation, whose flips are rolled back in between, or a network.
namespace program {

/// \tparam Traits the arithmetic, a model of `IntrinsicTriangulationTraits`
template <class Traits, class Metric>
class Curve_runner : public Curve_engine
{
  using Curve_index = CGAL::Flip_geodesics::Curve_index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Mesh, Traits, Metric>;
  using Network = CGAL::Flip_geodesics::Edge_path_network<Triangulation>;
  using Recorder = std::optional<Shortening_recorder<Network>>;

public:
  Curve_runner(
      const Mesh& mesh, const Metric& metric, const Run_options& options, Progress& progress,
      CGAL::Flip_geodesics::Zero_length_edges zero_length_edges = CGAL::Flip_geodesics::Zero_length_edges::REFUSE)
    : m_mesh(mesh)
    , m_metric(metric)
    , m_options(options)
    , m_progress(progress)
    , m_zero_length_edges(zero_length_edges)
    , m_triangulation(mesh, metric, Traits(), zero_length_edges)
    , m_search(m_triangulation, CGAL::parameters::search_method(options.search))
  {
  }

  /// If a degenerate edge is met, such edges are contracted, and the curve is computed again.
  std::vector<Curve_result> run(const Network_request& request) override
  {
    forget_last_run();
    const std::vector<Curve_result> results = results_or_failures(request);
    m_progress.add_curves(request.curves.size());
    return results;
  }

  /// The mesh, or what is left of it when its degenerate edges are contracted.
  const auto& input() const { return m_triangulation.input(); }

  void check(const Network_request& request) override
  {
    if(request.has_no_given_curves() || !request.curves.front().points.empty())
      return;
    namespace FG = CGAL::Flip_geodesics;
    m_progress.enter("searching for curves that cross");
    const std::string name = request.curves.size() == 1 ? request.curves.front().name + ": " : "the network: ";
    std::vector<Curve_result> results(request.curves.size());
    try {
      Network network(m_triangulation);
      build(network, request, results);
      network.clear();
      m_triangulation.rollback();
    } catch(const FG::Crossing_curves_error& error) {
      const std::string vertex = std::to_string(error.elements().front());
      throw Bad_input(name + error.what() + "; separate them, or use the command network with a line `! " + vertex +
                      "` in its file, which keeps them in place at this vertex");
    } catch(const FG::Ambiguous_order_error& error) {
      throw Bad_input(name + error.what() + "; move the curves to different edges");
    } catch(const FG::Error&) {
      m_triangulation.rollback(); // not a matter of the curves: reported when they are computed
    }
  }

private:
  // Returns the message of an error, with the program's advice. It does not name a vertex that was inserted for a
  // point: the mesh does not have it.
  std::string message(const std::exception& error) const
  {
    const auto* const crossing = dynamic_cast<const CGAL::Flip_geodesics::Crossing_curves_error*>(&error);
    if(crossing != nullptr &&
       (crossing->elements().size() > 1 || crossing->elements().front() >= m_mesh.number_of_vertices()))
      return "the curve crosses itself, which --draw, --stop-length, --insert, --cut and the command `refine` do not "
             "allow; move its points, or omit these options";
    if(crossing != nullptr)
      return std::string(error.what()) + "; separate them";
    return with_advice(error, m_options.are_zero_edges_refused ? "omit --refuse-zero-edges or use --mollify"
                                                               : "use --mollify");
  }

  // For `compute_on_surface()`, which decides whether degenerate edges are contracted.
  struct Surfaces
  {
    Curve_runner& runner;

    Curve_runner& as_is() { return runner; }
    Curve_runner& contracted()
    {
      runner.start_afresh();
      return runner.on_surface();
    }
  };

  std::vector<Curve_result> results_or_failures(const Network_request& request)
  {
    std::string why;
    try {
      if(m_options.are_zero_edges_refused)
        return compute(request);
      return CGAL::Flip_geodesics::internal::compute_on_surface(
          Surfaces{*this}, [&](Curve_runner& runner) { return results_of(runner, request); });
    } catch(const Bad_input&) {
      throw; // a result that was not allowed, rather than a curve that failed
    } catch(const std::exception& error) {
      why = message(error);
    }
    start_afresh();
    m_on_surface.reset();
    return failures(request, why);
  }

  // A curve of which a point is left needs no computation; the others are computed together.
  std::vector<Curve_result> compute(const Network_request& request)
  {
    forget_last_run();
    const Surface_request left = surface_request(m_triangulation, request);
    const bool is_contracted = m_triangulation.input().is_contracted();
    std::vector<Curve_result> computed, results;
    if(left.request.has_no_given_curves() || !left.request.curves.empty()) {
      computed = compute_lines(left.request);
    } else {
      Network none(m_triangulation);
      make_meshes(none);
      m_triangulation.rollback();
    }
    if(left.request.has_no_given_curves()) {
      if(is_contracted)
        put_on_mesh(m_triangulation, computed, m_map);
      return computed;
    }
    std::size_t next = 0;
    for(std::size_t c = 0; c < request.curves.size(); ++c) {
      if(left.places[c]) {
        results.push_back(make_result(request.curves[c]));
        make_point(m_triangulation, *left.places[c], results.back());
      } else {
        results.push_back(std::move(computed[next++]));
      }
      if(is_contracted)
        put_on_mesh(request.curves[c], results.back());
    }
    return results;
  }

  std::vector<Curve_result> compute_lines(const Network_request& request)
  {
    std::vector<Curve_result> results;
    for(const Curve_request& curve : request.curves)
      results.push_back(make_result(curve));
    if(is_shortest_between_points(request))
      find_shortest_between_points(request.curves.front(), results.front());
    else if(may_have_free_legs(request))
      run_free_legs(request.curves.front(), results.front());
    else
      run_network(request, results);
    if(m_most_recorded_points > 0 && !m_options.meshes.refine &&
       (may_have_free_legs(request) || is_straightened(request)))
      record_flips_alone(request, results);
    return results;
  }

  // After a failure, whatever it left.
  void start_afresh()
  {
    forget_last_run();
    m_triangulation = Triangulation(m_mesh, m_metric, Traits(), m_zero_length_edges);
  }

  std::vector<Curve_result> failures(const Network_request& request, const std::string& why) const
  {
    std::vector<Curve_result> results;
    for(const Curve_request& curve : request.curves)
      results.push_back(make_result(curve));
    if(request.has_no_given_curves())
      results.assign(1, whole_result(request));
    for(Curve_result& result : results)
      result.error = why.substr(0, why.find('\n'));
    return results;
  }

  // With the degenerate edges contracted.
  Curve_runner& on_surface()
  {
    if(!m_on_surface)
      m_on_surface = std::make_unique<Curve_runner>(m_mesh, m_metric, m_options, m_progress,
                                                    CGAL::Flip_geodesics::Zero_length_edges::CONTRACT);
    m_on_surface->set_most_recorded_points(m_most_recorded_points);
    return *m_on_surface;
  }

  std::vector<Curve_result> results_of(Curve_runner& runner, const Network_request& request)
  {
    std::vector<Curve_result> results = runner.compute(request);
    if(&runner != this)
      take_results(runner);
    return results;
  }

  void take_results(Curve_runner& other)
  {
    m_record = std::move(other.m_record);
    m_map = std::move(other.m_map);
    m_meshes = std::move(other.m_meshes);
    m_mesh_results = std::move(other.m_mesh_results);
    m_tree_results = std::move(other.m_tree_results);
  }

  void forget_last_run()
  {
    m_record.reset();
    m_map.reset();
    m_meshes = Result_meshes();
    m_mesh_results.clear();
    m_tree_results.clear();
  }

  void build(Network& network, const Network_request& request, std::vector<Curve_result>& results,
             bool by_flips_alone = false)
  {
    for(std::size_t c = 0; c < request.curves.size(); ++c) {
      const Stopwatch stopwatch;
      if(request.curves[c].is_drawn) {
        m_progress.enter("drawing");
        draw(network, request.curves[c], results[c]);
        continue;
      }
      m_progress.enter("searching");
      if(!request.curves[c].points.empty()) {
        const auto curve = request.curves[c].spline
                               ? add_spline(network, request.curves[c], results[c])
                               : add_curve_through(network, request.curves[c].points,
                                                   CGAL::parameters::is_closed(request.curves[c].is_closed));
        results[c].search_s = stopwatch.seconds();
        results[c].initial_segments = network.halfedges(curve).size();
        continue;
      }
      const std::vector<Halfedge_index> halfedges = initial_halfedges(request.curves[c]);
      results[c].search_s = stopwatch.seconds();
      results[c].initial_segments = halfedges.size();
      if(is_straightened(request) && !by_flips_alone) {
        m_progress.enter("straightening");
        results[c].flips = add_straightened_path(network, halfedges, m_options.memory_limit);
        m_progress.add_flips(results[c].flips);
        results[c].shorten_s = stopwatch.seconds() - results[c].search_s;
      } else {
        network.add_curve(halfedges, CGAL::parameters::is_closed(request.curves[c].is_closed));
      }
    }
    for(Vertex_index v : request.fixed_vertices)
      network.fix_nodes_at(v);
    if(!request.curves.front().is_drawn || m_options.is_snapped)
      order_overlapping_curves(network);
  }

  // Is there one curve, of which only the ends are given?
  bool is_straightened(const Network_request& request) const
  {
    return request.curves.size() == 1 && request.curves.front().is_pair && request.fixed_vertices.empty() &&
           !m_options.stop_length;
  }

  void run_network(const Network_request& request, std::vector<Curve_result>& results)
  {
    Network network(m_triangulation);
    Recorder recorder;
    if(request.tree_source) {
      grow(network, *request.tree_source, results);
      certify(network, results);
    } else if(request.is_cut_graph) {
      cut_to_disks(network, results);
    } else if(is_shortest_pair(request)) {
      find_shortest(network, request.curves.front(), results.front());
    } else {
      build(network, request, results);
      shorten(network, results, recorder);
    }
    extract(network, results);
    make_meshes(network);
    record(network, recorder);
    network.clear();
    m_triangulation.rollback();
  }

  void make_meshes(Network& network)
  {
    m_mesh_results = improve_triangulation(m_options.meshes, network, m_progress);
    if(m_options.meshes.has_files())
      m_progress.enter("inserting the curves into the mesh");
    m_meshes = result_meshes(m_options.meshes, m_mesh, network);
  }

  // Is the shortest of all paths between two points wanted that are not both vertices?
  bool is_shortest_between_points(const Network_request& request) const
  {
    return m_options.is_shortest && !request.has_no_given_curves() && !request.curves.front().points.empty();
  }

  // Is the shortest of all paths between two vertices wanted?
  bool is_shortest_pair(const Network_request& request) const
  {
    return m_options.is_shortest && is_straightened(request);
  }

  // Landmarks are those of the mesh, not of what is left of it when edges are contracted.
  const CGAL::Flip_geodesics::Geodesic_landmarks* landmarks() const
  {
    const bool is_mesh = m_zero_length_edges == CGAL::Flip_geodesics::Zero_length_edges::REFUSE;
    return is_mesh ? m_options.landmarks : nullptr;
  }

  void find_shortest(Network& network, const Curve_request& request, Curve_result& result)
  {
    const Stopwatch stopwatch;
    m_progress.enter("searching for the shortest path", "steps");
    Progress_visitor visitor(m_progress);
    Noted_search search(m_search);
    const auto report =
        add_shortest_pair(network, search, landmarks(), request.vertices, m_options.memory_limit, visitor);
    check_folds(report.shortening);
    note(report.shortening, report.shortening.curves.front(), result);
    result.status = to_string(report.verdict);
    result.initial_segments = search.segments();
    result.search_s = search.seconds();
    result.shorten_s = stopwatch.seconds() - result.search_s;
  }

  // The library makes the points vertices of a triangulation of its own.
  void find_shortest_between_points(const Curve_request& request, Curve_result& result)
  {
    namespace FG = CGAL::Flip_geodesics;
    const Stopwatch stopwatch;
    m_progress.enter("searching for the shortest path", "steps");
    Progress_visitor visitor(m_progress);
    std::vector<std::pair<Mesh::Face_index, std::array<double, 3>>> path;
    const FG::Shortest_path_report report =
        FG::shortest_path(
            m_mesh, request.points[0], request.points[1], std::back_inserter(path), CGAL::parameters::metric(m_metric),
            CGAL::parameters::geom_traits(Traits()),
            CGAL::parameters::search_limit(window_limit(m_mesh.number_of_vertices(), m_options.memory_limit)),
            CGAL::parameters::visitor(std::ref(visitor)))
            .report;
    note(report.shortening, report.shortening.curves.front(), result);
    result.status = to_string(report.verdict);
    result.length = report.length;
    result.are_zero_edges_contracted = report.shortening.curves.front().are_zero_edges_contracted;
    result.shorten_s = stopwatch.seconds();
    result.initial_segments = path.size() - 1;
    for(const auto& at : path) {
      const FG::Surface_point p = FG::surface_point(m_triangulation, FG::surface_location(m_triangulation, m_mesh, at));
      result.points.push_back({p, FG::point_in_space(m_triangulation, p), &at == &path.front() || &at == &path.back()});
    }
    note_ends(result);
    m_meshes = meshes_along(m_mesh, {result}, m_options.meshes, m_progress);
  }

  // Records how flips alone shorten the curve that is known by now. Results are not changed, so they are the
  // same with and without a page.
  void record_flips_alone(const Network_request& request, const std::vector<Curve_result>& results)
  {
    std::vector<Curve_result> others = {make_result(request.curves.front())};
    Network network(m_triangulation);
    Recorder recorder;
    try {
      build(network, request, others, true);
      shorten(network, others, recorder);
      const double length = results.front().length;
      if(std::abs(others.front().length - length) <= 1e-9 * length) {
        record(network, recorder);
      } else if(is_straightened(request)) {
        network.clear();
        m_triangulation.rollback();
        record_straightening(network, request);
      }
    } catch(const CGAL::Flip_geodesics::Error&) { // what is known stays
    }
    network.clear();
    m_triangulation.rollback();
  }

  // Records a start and an end alone, where flips lead to another geodesic than straightening or a search does.
  void record_straightening(Network& network, const Network_request& request)
  {
    const std::vector<Halfedge_index> halfedges = initial_halfedges(request.curves.front());
    network.add_curve(halfedges);
    Recorder recorder;
    recorder.emplace(network, m_most_recorded_points);
    network.clear();
    if(is_shortest_pair(request)) {
      Progress_visitor visitor(m_progress);
      add_shortest_pair(network, m_search, landmarks(), request.curves.front().vertices, m_options.memory_limit,
                        visitor);
    } else {
      add_straightened_path(network, halfedges, m_options.memory_limit);
      CGAL::Flip_geodesics::shorten(network, CGAL::parameters::stop_predicate(memory_limit()));
    }
    record(network, recorder);
  }

  // May the curve's legs be pulled straight each by itself? Then they can cross, and no triangulation has them all.
  bool may_have_free_legs(const Network_request& request) const
  {
    return !request.has_no_given_curves() && !request.curves.front().points.empty() &&
           !request.curves.front().is_drawn && !m_options.is_shortest && !m_options.meshes.is_any_wanted() &&
           !m_options.stop_length;
  }

  void run_free_legs(const Curve_request& request, Curve_result& result)
  {
    namespace FG = CGAL::Flip_geodesics;
    const Stopwatch stopwatch;
    FG::Free_legs path;
    if(request.spline) {
      path = spline(request);
    } else {
      m_progress.enter("shortening", "steps");
      Progress_visitor visitor(m_progress);
      path = FG::geodesics_through(m_triangulation, request.points, CGAL::parameters::stop_predicate(memory_limit()),
                                   CGAL::parameters::visitor(std::ref(visitor)));
    }
    note(path.report, path.report.curves.front(), result);
    result.initial_segments = path.legs.size();
    result.shorten_s = stopwatch.seconds();
    for(const std::vector<FG::Surface_location>& leg : path.legs)
      for(std::size_t i = &leg == &path.legs.front() ? 0 : 1; i < leg.size(); ++i) { // a leg starts where one ends
        const FG::Surface_point p = FG::surface_point(m_triangulation, leg[i]);
        result.points.push_back({p, FG::point_in_space(m_triangulation, p), i == 0 || i + 1 == leg.size()});
      }
    note_ends(result);
  }

  // Computes a spline as geodesics between points on it. \pre no network has curves in the triangulation
  CGAL::Flip_geodesics::Free_legs spline(const Curve_request& request)
  {
    m_progress.enter("subdividing", "rounds", static_cast<std::size_t>(m_options.rounds));
    CGAL::Flip_geodesics::Geodesic_spline<Triangulation> spline(m_triangulation, request.points, *request.spline);
    for(int i = 0; i < m_options.rounds; ++i, m_progress.add_steps(1))
      spline.refine();
    CGAL::Flip_geodesics::Free_legs result = {spline.finish(), spline.report()};
    m_progress.add_flips(result.report.flips);
    return result;
  }

  // Adds a spline to a network, whose initial length is that of its control polygon.
  Curve_index add_spline(Network& network, const Curve_request& request, Curve_result& result)
  {
    const CGAL::Flip_geodesics::Free_legs pieces = spline(request);
    const Curve_index curve = add_curve_along(network, pieces.legs, CGAL::parameters::is_closed(request.is_closed));
    network.set_initial_length(curve, pieces.report.curves.front().initial_length);
    result.flips = pieces.report.flips;
    return curve;
  }

  static void note(const CGAL::Flip_geodesics::Shortening_report& run, const CGAL::Flip_geodesics::Curve_report& curve,
                   Curve_result& result)
  {
    result.initial_length = curve.initial_length;
    result.length = curve.length;
    result.flips = run.flips;
    result.flip_outs = run.flip_outs;
    result.smallest_angle = curve.smallest_angle;
    result.status = to_string(curve.status);
    if(curve.verdict != CGAL::Flip_geodesics::Verdict::UNDECIDED)
      result.certificate = to_string(curve.verdict);
    if(curve.status == CGAL::Flip_geodesics::Shortening_status::MEMORY_LIMIT)
      result.error = "shortening ended early because the flips require too much memory; increase --memory-limit";
  }

  // Adds a polyline, or its snapped path, as a curve without fixed nodes. \pre the network has no curve
  void draw(Network& network, const Curve_request& request, Curve_result& result)
  {
    namespace FG = CGAL::Flip_geodesics;
    const Stopwatch stopwatch;
    const auto polyline =
        FG::complete_polyline(m_triangulation, request.points, CGAL::parameters::is_closed(request.is_closed));
    Curve_index curve;
    if(m_options.is_snapped) {
      const std::vector<Vertex_index> path =
          FG::snap_polyline(m_triangulation, polyline, CGAL::parameters::is_closed(request.is_closed));
      curve = network.add_curve(
          FG::halfedges_through(m_triangulation, path, CGAL::parameters::is_closed(request.is_closed)),
          CGAL::parameters::is_closed(request.is_closed));
    } else {
      curve = FG::draw_polyline(network, polyline, CGAL::parameters::is_closed(request.is_closed));
      FG::order_overlapping_curves(network);
      FG::shorten(network, CGAL::parameters::stop_predicate(memory_limit()));
      network.reset_initial_length(curve);
      network.free_nodes(curve);
    }
    result.initial_segments = network.halfedges(curve).size();
    result.search_s = stopwatch.seconds();
  }

  // Grows the tree from a source, which becomes a vertex, with a curve for each of its edges.
  void grow(Network& network, const CGAL::Flip_geodesics::Surface_location& source, std::vector<Curve_result>& results)
  {
    namespace FG = CGAL::Flip_geodesics;
    const Stopwatch stopwatch;
    m_progress.enter("growing the tree", "steps");
    Progress_visitor visitor(m_progress);
    FG::Geodesic_tree<Triangulation> tree(m_triangulation);
    const FG::Geodesic_tree_report report =
        tree.grow(network.insert(source), CGAL::parameters::visitor(std::ref(visitor)));
    FG::Distances_report shortest;
    shortest.status = report.status;
    if(m_options.is_shortest) {
      m_progress.enter("searching for shorter paths", "steps");
      shortest = FG::make_shortest(tree, CGAL::parameters::visitor(std::ref(visitor)));
      m_progress.add_flips(shortest.flips);
    }
    if(m_options.has_map) {
      m_progress.enter("mapping vertices", "vertices", static_cast<std::size_t>(m_triangulation.number_of_vertices()));
      Share_visitor share(m_progress);
      m_map = map_of_mesh(FG::internal::logarithmic_map_of_tree(tree, Input_halfedge_index(), share));
    }
    m_tree_results = describe_tree(tree, report.flips + shortest.flips);
    if(m_options.is_shortest)
      m_tree_results += describe_shortest_paths(shortest);
    Curve_result common;
    common.flips = report.flips + shortest.flips;
    common.flip_outs = report.flip_outs;
    common.smallest_angle = report.smallest_angle;
    common.status = to_string(shortest.status);
    common.initial_segments = 1;
    common.shorten_s = stopwatch.seconds();
    const auto number_of_vertices = m_triangulation.number_of_vertices();
    m_progress.enter("extracting curves from the tree", "vertices", static_cast<std::size_t>(number_of_vertices));
    for(Vertex_index v(0); v.idx() < number_of_vertices; ++v) {
      m_progress.add_steps(1);
      const Halfedge_index h = tree.incoming(v);
      if(!h.is_valid())
        continue;
      network.add_curve(std::vector<Halfedge_index>{h});
      results.push_back(common);
      results.back().is_of_tree = true;
      results.back().name = "to vertex " + std::to_string(v.idx());
      results.back().source = m_triangulation.tail(h);
      results.back().target = v;
      results.back().length = results.back().initial_length = m_triangulation.length(h);
    }
  }

  // The map without the source if that was inserted.
  CGAL::Flip_geodesics::Vertex_logarithmic_map map_of_mesh(
      const CGAL::Flip_geodesics::Vertex_logarithmic_map& map) const
  {
    CGAL::Flip_geodesics::Vertex_logarithmic_map result(m_triangulation.input().number_of_vertices(), map.total_angle(),
                                                        map.is_on_border());
    for(Vertex_index v(0); v.idx() < m_triangulation.input().number_of_vertices(); ++v)
      result[v] = map[v];
    return result;
  }

  // Adds the cut graph of the surface and shortens it.
  void cut_to_disks(Network& network, std::vector<Curve_result>& results)
  {
    namespace FG = CGAL::Flip_geodesics;
    const Stopwatch stopwatch;
    m_progress.enter("computing the cut graph");
    FG::add_cut_graph(network);
    const double search_s = stopwatch.seconds();
    m_progress.enter("shortening", "steps");
    Progress_visitor visitor(m_progress);
    const FG::Shortening_report report = FG::shorten_cut_graph(network, CGAL::parameters::visitor(std::ref(visitor)));
    for(std::size_t c = 0; c < report.curves.size(); ++c) {
      results.emplace_back();
      results.back().name = "cut " + std::to_string(c);
      results.back().is_closed = network.is_closed(Curve_index(static_cast<Index>(c)));
      note(report, report.curves[c], results.back());
      results.back().search_s = search_s;
      results.back().shorten_s = stopwatch.seconds() - search_s;
    }
  }

  std::vector<Halfedge_index> initial_halfedges(const Curve_request& request)
  {
    namespace FG = CGAL::Flip_geodesics;
    if(request.is_pair)
      return FG::shortest_halfedges_through(m_search, request.vertices);
    return FG::internal::halfedges_on_surface(m_triangulation, request.vertices, request.is_closed);
  }

  CGAL::Flip_geodesics::Memory_stop_predicate memory_limit() const
  {
    return CGAL::Flip_geodesics::Memory_stop_predicate(m_options.memory_limit);
  }

  // A ratio of zero does not limit anything.
  auto limits() const
  {
    namespace FG = CGAL::Flip_geodesics;
    return FG::Any_stop_predicate(FG::Length_ratio_stop_predicate(m_options.stop_length.value_or(0)),
                                  FG::Curve_length_ratio_stop_predicate(m_options.stop_curve_length.value_or(0)),
                                  memory_limit());
  }

  void shorten(Network& network, std::vector<Curve_result>& results, Recorder& recorder)
  {
    namespace FG = CGAL::Flip_geodesics;
    if(m_most_recorded_points > 0)
      recorder.emplace(network, m_most_recorded_points);
    const Stopwatch stopwatch;
    m_progress.enter("shortening", "steps");
    Recording_visitor<Network> visitor(m_progress, recorder);
    const FG::Shortening_report report =
        FG::shorten(network, CGAL::parameters::stop_predicate(limits()), CGAL::parameters::visitor(std::ref(visitor)));
    const double seconds = stopwatch.seconds();
    check_folds(report);
    for(std::size_t c = 0; c < results.size(); ++c) {
      const std::size_t flips_before = results[c].flips;
      note(report, report.curves[c], results[c]);
      results[c].flips += flips_before;
      results[c].shorten_s += seconds;
    }
  }

  void check_folds(const CGAL::Flip_geodesics::Shortening_report& report) const
  {
    namespace FG = CGAL::Flip_geodesics;
    if(!m_options.are_zero_edges_refused && FG::internal::are_curves_folded(m_triangulation, report))
      throw FG::Degenerate_face_error(
          "a curve is blocked by vertices that coincide because of degenerate faces; use --repair or --mollify", {});
  }

  // Where vertices are inserted the record has no steps but the finished triangulation.
  void record(const Network& network, Recorder& recorder)
  {
    if(m_most_recorded_points == 0)
      return;
    if(!recorder || m_options.meshes.refine)
      recorder.emplace(network, m_most_recorded_points);
    m_record = recorder->finish();
    if(m_record->steps.empty() && number_of_points(*m_record) > m_most_recorded_points)
      m_record.reset();
  }

  // The vertices where an open curve that has been read off starts and ends.
  static void note_ends(Curve_result& result)
  {
    if(result.is_closed || result.points.empty())
      return;
    result.source = vertex_at(result.points.front().on_surface);
    result.target = vertex_at(result.points.back().on_surface);
  }

  static Vertex_index vertex_at(const CGAL::Flip_geodesics::Surface_point& p)
  {
    return p.is_vertex() ? p.a : Vertex_index();
  }

  void extract(Network& network, std::vector<Curve_result>& results)
  {
    m_progress.enter("extracting curves", "curves", results.size());
    CGAL::Flip_geodesics::Curve_extractor<Network> extractor(network);
    for(std::size_t c = 0; c < results.size(); ++c) {
      const Stopwatch stopwatch;
      for(const auto& p : extractor.surface_points(Curve_index(static_cast<Index>(c))))
        results[c].points.push_back({p, extractor.point(p), p.vertex.is_valid()});
      note_ends(results[c]);
      results[c].extract_s = stopwatch.seconds();
      m_progress.add_steps(1);
    }
  }

  // Proves the paths of a tree from the input alone; what was shortened has its verdict in the report.
  void certify(Network& network, std::vector<Curve_result>& results)
  {
    if(Triangulation::Traits::Has_drift::value)
      return;
    m_progress.enter("certifying");
    //! [Certify]
    const CGAL::Flip_geodesics::Network_certificate certificate = CGAL::Flip_geodesics::certify(network);
    for(std::size_t c = 0; c < results.size(); ++c)
      results[c].certificate = to_string(certificate.curves[c].verdict());
    //! [Certify]
  }

  const Mesh& m_mesh;
  const Metric& m_metric;
  Run_options m_options;
  Progress& m_progress;
  CGAL::Flip_geodesics::Zero_length_edges m_zero_length_edges;
  Triangulation m_triangulation;
  CGAL::Flip_geodesics::Shortest_edge_path<Triangulation> m_search;
  std::unique_ptr<Curve_runner> m_on_surface; // with degenerate edges contracted, created when first needed
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_CURVE_RUNNER_H
