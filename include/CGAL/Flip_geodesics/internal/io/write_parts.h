// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_WRITE_PARTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_WRITE_PARTS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>
#include <CGAL/Flip_geodesics/internal/io/figure_of_parts.h>

#include <CGAL/Named_function_parameters.h>

#include <fstream>
#include <ios>
#include <limits>
#include <locale>
#include <ostream>
#include <string>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* How numbers are written. */
struct Number_format
{
  int precision = std::numeric_limits<double>::max_digits10; // so that doubles come back
  bool is_binary = true;
};

/* Writes by `write(plain)`, where the stream has the buffer of `out` but none of its settings, and no locale. */
template <class Write>
void write_plainly(std::ostream& out, int precision, const Write& write)
{
  std::ostream plain(nullptr);
  plain.imbue(std::locale::classic()); // without a buffer, which would take it as well
  plain.precision(precision);
  plain.rdbuf(out.rdbuf());
  if(out)
    write(plain);
  if(out && plain.flush())
    return;
  out.setstate(std::ios::badbit);
  throw File_write_error("the file could not be written to its end; look for space on the disk");
}

template <class Writer>
void write_to(std::ostream& out, const Writer& writer, const Number_format& format)
{
  write_plainly(out, format.precision, [&](std::ostream& plain) { writer.write(plain); });
}

template <class Writer>
void write_to(const std::string& name, const Writer& writer, const Number_format& format)
{
  std::ofstream out(name, std::ios::binary);
  if(!out)
    throw File_write_error(name + ": cannot be written; choose another place");
  write_to(out, writer, format);
  out.close();
  if(!out)
    throw File_write_error(name + ": could not be written to its end; look for space on the disk");
}

/*
 * Writes by a `Writer` made of a figure and a format, whose construction throws if the figure cannot be written. So
 * nothing is written, and no file touched then.
 */
template <class Writer, class Destination, class... Parts>
void write_parts(Destination& destination, const Parts&... parts)
{
  const auto& np = named_parameters_of(parts...);
  Number_format format;
  format.precision =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::stream_precision), format.precision);
  format.is_binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), true);
  const Figure figure = figure_of_parts(np, parts...);
  write_to(destination, Writer(figure, format), format);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_WRITE_PARTS_H
