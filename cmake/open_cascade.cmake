# SPDX-License-Identifier: GPL-3.0-or-later
# The target OpenCascade::Exchange: what reading and writing STEP and IGES files needs.
#
# Not find_package(OpenCASCADE): Debian's file for it asks for libtbb.so, which its packages do not
# require. Release 7.8 has put the toolkits of a format into one, TKDESTEP and TKDEIGES.
find_path(OPEN_CASCADE_INCLUDE_DIR STEPControl_Writer.hxx PATH_SUFFIXES opencascade occt REQUIRED)
add_library(OpenCascade::Exchange INTERFACE IMPORTED)
target_include_directories(OpenCascade::Exchange SYSTEM INTERFACE ${OPEN_CASCADE_INCLUDE_DIR})

find_library(OPEN_CASCADE_TKDESTEP TKDESTEP)
if(OPEN_CASCADE_TKDESTEP)
  set(exchange_toolkits TKDESTEP TKDEIGES)
else()
  set(exchange_toolkits TKSTEP TKSTEPAttr TKSTEPBase TKIGES)
endif()
foreach(toolkit ${exchange_toolkits} TKXSBase TKBO TKPrim TKMesh TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OPEN_CASCADE_${toolkit} ${toolkit} REQUIRED)
  target_link_libraries(OpenCascade::Exchange INTERFACE ${OPEN_CASCADE_${toolkit}})
endforeach()
