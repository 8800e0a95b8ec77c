# SPDX-License-Identifier: GPL-3.0-or-later
# The target OpenCascade::Step: what reading and writing STEP files needs.
#
# Not find_package(OpenCASCADE): Debian's file for it asks for libtbb.so, which its packages do not
# require. Release 7.8 has renamed the STEP toolkits to one, TKDESTEP.
find_path(OPEN_CASCADE_INCLUDE_DIR STEPControl_Writer.hxx PATH_SUFFIXES opencascade occt REQUIRED)
add_library(OpenCascade::Step INTERFACE IMPORTED)
target_include_directories(OpenCascade::Step SYSTEM INTERFACE ${OPEN_CASCADE_INCLUDE_DIR})

find_library(OPEN_CASCADE_TKDESTEP TKDESTEP)
if(OPEN_CASCADE_TKDESTEP)
  set(step_toolkits TKDESTEP)
else()
  set(step_toolkits TKSTEP TKSTEPBase)
endif()
foreach(toolkit ${step_toolkits} TKXSBase TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OPEN_CASCADE_${toolkit} ${toolkit} REQUIRED)
  target_link_libraries(OpenCascade::Step INTERFACE ${OPEN_CASCADE_${toolkit}})
endforeach()
