# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -P check_sources.cmake: fails unless viewer_page.html was built from the sources as they are.

file(READ "${CMAKE_CURRENT_LIST_DIR}/viewer_page.html" page LIMIT 4000)
file(GLOB sources RELATIVE "${CMAKE_CURRENT_LIST_DIR}" "${CMAKE_CURRENT_LIST_DIR}/source/*")
if(NOT sources)
  message(FATAL_ERROR "no sources")
endif()
foreach(source IN LISTS sources)
  file(SHA256 "${CMAKE_CURRENT_LIST_DIR}/${source}" hash)
  string(FIND "${page}" "${source} ${hash}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "viewer_page.html is older than ${source}: npm ci && npm run build")
  endif()
endforeach()
