# SPDX-License-Identifier: MIT
# The libraries that the project is built on; tests, benchmarks and fuzz targets ask for
# theirs themselves. Included at the top, so that every folder sees the targets.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Boost REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
# Lua compiled as C++: its errors are exceptions, which run destructors.
pkg_check_modules(LUA REQUIRED IMPORTED_TARGET lua5.4-c++)

# The reference path of the physical world; everything else builds without it.
set(STIG_PHYSICS AUTO CACHE STRING "Build the reference path of physics on DART: AUTO, ON, OFF")
set_property(CACHE STIG_PHYSICS PROPERTY STRINGS AUTO ON OFF)
set(STIG_WITH_DART OFF)
if(NOT STIG_PHYSICS STREQUAL "OFF")
  find_package(DART 6.12 CONFIG QUIET)
  if(TARGET dart)
    set(STIG_WITH_DART ON)
  elseif(STIG_PHYSICS STREQUAL "ON")
    message(FATAL_ERROR "STIG_PHYSICS is ON, but DART 6.12 is not found (libdart-dev)")
  else()
    message(STATUS "DART 6.12 is not found (libdart-dev): physics without its reference path")
  endif()
endif()

# Headers alone, and no CMake package of their own.
find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
mark_as_advanced(RANDOM123_INCLUDE_DIR)
add_library(Random123::Random123 INTERFACE IMPORTED)
target_include_directories(Random123::Random123 INTERFACE ${RANDOM123_INCLUDE_DIR})

find_path(CADICAL_INCLUDE_DIR cadical.hpp REQUIRED)
find_library(CADICAL_LIBRARY cadical REQUIRED)
mark_as_advanced(CADICAL_INCLUDE_DIR CADICAL_LIBRARY)
add_library(Cadical::Cadical STATIC IMPORTED)
set_target_properties(Cadical::Cadical PROPERTIES
  IMPORTED_LOCATION ${CADICAL_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${CADICAL_INCLUDE_DIR})
