# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of others that most tests include, read once: a quarter of the time to compile them. Where CMAKE_UNITY_BUILD is
# off each source is compiled by itself, so that an include that is missing shows. Not for what is packaged: GCC takes
# precompiled headers of the system's for ours, and finds overflows in std::string that are none.

# hull_headers(NAME LIBRARIES HEADERS...): headers precompiled as a target NAME that links to LIBRARIES, with the
# flags that hold in this folder; nothing where it is off.
function(hull_headers name libraries)
  if(CMAKE_UNITY_BUILD)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "")
    add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${libraries})
    target_precompile_headers(${name} PRIVATE ${ARGN})
  endif()
endfunction()

# hull_use_headers(TARGET NAME): a target whose flags are those of the headers NAME includes them first.
function(hull_use_headers target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
