# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -P check_sources.cmake: fails unless viewer_page.html and live_page.html were built from the sources of the pages
# as they are, and the engine in the latter from live/. What else went into the engine, headers of the library and parts
# of the program, may be newer, as it needs Emscripten: then the engine is said to be older, and that test is left out;
# what it computes is compared with the program by the test that drags points. With -D STRICT=ON that fails, too.

function(read_hashes page result)
  file(READ "${CMAKE_CURRENT_LIST_DIR}/${page}" text LIMIT 60000)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

read_hashes(viewer_page.html viewer)
read_hashes(live_page.html live)

# Is the file in the text, with the hash that it has?
function(find_hash file name text result)
  set(${result} FALSE PARENT_SCOPE)
  if(EXISTS "${file}")
    file(SHA256 "${file}" hash)
    string(FIND "${text}" "${name} ${hash}" place)
    if(NOT place EQUAL -1)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

function(check_folder page text)
  set(count 0)
  foreach(pattern IN LISTS ARGN)
    file(GLOB sources RELATIVE "${CMAKE_CURRENT_LIST_DIR}" "${CMAKE_CURRENT_LIST_DIR}/${pattern}")
    foreach(source IN LISTS sources)
      math(EXPR count "${count} + 1")
      find_hash("${CMAKE_CURRENT_LIST_DIR}/${source}" "${source}" "${text}" is_found)
      if(NOT is_found)
        message(FATAL_ERROR "${page} is older than ${source}: npm ci && npm run build")
      endif()
    endforeach()
  endforeach()
  if(count EQUAL 0)
    message(FATAL_ERROR "no sources of ${page}")
  endif()
endfunction()

check_folder(viewer_page.html "${viewer}" source/*)
check_folder(live_page.html "${live}" source/data.js source/frame.html source/playback.js source/stage.js
             source/style.css source/words.js source_live/*)

get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
string(REGEX MATCHALL "[^\n ]+ [0-9a-f]+" lines "${live}")
set(count 0)
set(newer "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " .*" "" name "${line}")
  if(NOT name MATCHES "^(include|examples)/")
    continue()
  endif()
  math(EXPR count "${count} + 1")
  find_hash("${root}/${name}" "${name}" "${line}" is_found)
  if(is_found)
    continue()
  elseif(name MATCHES "/live/" OR STRICT)
    message(FATAL_ERROR "live_page.html is older than ${name}: npm ci && npm run build-engine")
  endif()
  list(APPEND newer "${name}")
endforeach()
if(count LESS 100)
  message(FATAL_ERROR "live_page.html does not say what its engine was made of")
endif()
if(newer)
  list(LENGTH newer number)
  list(GET newer 0 first)
  message(STATUS "The engine of live_page.html is older than ${number} of ${count} files, such as ${first}: npm run build-engine before a release")
endif()
