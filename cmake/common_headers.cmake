# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of others that most sources include, read once where sources are compiled together: a quarter of the time for
# all of them. Where sources are compiled by themselves they are not, so that an include that is missing shows.

set(HULL_COMMON_HEADERS
  <algorithm> <array> <cmath> <functional> <map> <memory> <numbers> <optional> <random> <sstream> <stdexcept> <string>
  <vector> <Eigen/Dense> <Eigen/SparseCore>)

# hull_common_headers(NAME HEADERS...): a target NAME, of which others that are compiled with the same options take
# the common headers and HEADERS by hull_use_headers(TARGET NAME). The target itself must have been added.
function(hull_common_headers name)
  if(CMAKE_UNITY_BUILD)
    target_precompile_headers(${name} PRIVATE ${HULL_COMMON_HEADERS} ${ARGN})
  endif()
endfunction()

function(hull_use_headers target name)
  if(CMAKE_UNITY_BUILD)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
