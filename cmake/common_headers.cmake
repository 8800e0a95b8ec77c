# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of others that most sources include, read once where sources are compiled together: a sixth of a unit's
# time. Where sources are compiled by themselves they are not, so that an include that is missing shows.

set(HULL_COMMON_HEADERS
  <algorithm> <array> <cmath> <functional> <map> <memory> <numbers> <optional> <random> <sstream> <stdexcept> <string>
  <vector> <Eigen/Dense> <Eigen/SparseCore>)

# hull_take_common_headers(TARGET KIND HEADERS...): the first target of a kind with the same options reads the common
# headers and HEADERS, the others take them from it.
function(hull_take_common_headers target kind)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  get_target_property(options ${target} COMPILE_OPTIONS)
  string(MD5 group "${kind} ${options}")
  get_property(first GLOBAL PROPERTY hull_headers_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${HULL_COMMON_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY hull_headers_${group} ${target})
  endif()
endfunction()
