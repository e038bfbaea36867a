// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H

#include "output/output_file.h"
#include "output/packed_array.h"
#include "output/scene_json.h"
#include "page_template.h"
#include "scene.h"

#include <string>
#include <string_view>

namespace program {

/*!
 * Writes one page for a browser that shows a scene, with everything in it: no other file and no network is needed.
 *
 * The page is a fixed one (folder page/), in which a JSON object takes the place of a mark.
 */
class Page_file
{
public:
  /// With an empty name, nothing is written.
  explicit Page_file(const std::string& name)
    : m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  void write(const Mesh& mesh, const Scene& scene)
  {
    if(!is_wanted())
      return;
    for(std::string_view piece : page_template) {
      if(piece == "@SCENE@")
        Scene_json(mesh, json_packed).write(m_file.stream(), scene);
      else
        m_file.stream() << piece;
    }
    m_file.close();
  }

private:
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
