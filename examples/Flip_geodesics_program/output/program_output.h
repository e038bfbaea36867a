// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H

#include "program_mesh.h"
#include "program_options.h"
#include "run/computations.h"
#include "run/curve_engine.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// Where the results go, for those who compute: without the writers, which are compiled by themselves.
namespace program {

class Outputs
{
public:
  virtual ~Outputs() = default;

  /// The number of points of the next run that are recorded for the page.
  virtual std::size_t most_recorded_points() const = 0;

  /// Writes the results of a run, and errors on standard error.
  virtual void write(const std::vector<Curve_result>& run, const std::optional<Shortening_record>& record) = 0;
  virtual void write(const CGAL::Flip_geodesics::Vertex_logarithmic_map& map) = 0;
  virtual void write(const Result_meshes& meshes) = 0;

  virtual void write(const Mesh_info& info) = 0;

  /// Writes the distances; the curves come as results.
  virtual void write(const Field_curves& field) = 0;

  /// Completes the files. \param remarks lines about the mesh and the results
  virtual void close(const Mesh& mesh, const std::vector<std::string>& remarks) = 0;

  /// Prints the table of the curves.
  virtual void print_summary(std::ostream& out) const = 0;

  virtual bool has_failed() const = 0;
};

/// Opens the files. \throws Bad_input
std::unique_ptr<Outputs> make_outputs(const Options& options);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H
