# SPDX-License-Identifier: GPL-3.0-or-later
# Where CMAKE_UNITY_BUILD is on, several sources are compiled as one: a third of the time for all of them, more for
# one that has changed. What is compiled together depends on its folder alone, so that names need be unique within a
# folder only, those of anonymous namespaces among them.

# hull_units(TARGET SOURCES...): sources in one folder are one unit, of eight sources at most.
function(hull_units target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  set(sources ${ARGN})
  list(SORT sources)
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    get_filename_component(folder ${path} DIRECTORY)
    file(RELATIVE_PATH group ${PROJECT_SOURCE_DIR} ${folder})
    string(REPLACE "/" "_" group ${group})
    math(EXPR count_${group} "0${count_${group}} + 1")
    math(EXPR part "(${count_${group}} - 1) / 8")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()
