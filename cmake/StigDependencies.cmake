# SPDX-License-Identifier: MIT
# The libraries that the project is built on; tests, benchmarks and fuzz targets ask for
# theirs themselves. Included at the top, so that every folder sees the targets.
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Boost REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(SQLITE3 REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
# Its headers depend on how it was built, which its package says.
pkg_check_modules(HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)
# Lua compiled as C++: its errors are exceptions, which run destructors.
pkg_check_modules(LUA REQUIRED IMPORTED_TARGET lua5.4-c++)

# The kinematics of joints, and a step of physics by others to compare with.
find_package(DART 6.12 REQUIRED CONFIG)

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
