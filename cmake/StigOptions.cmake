# SPDX-License-Identifier: MIT
# Compile settings that every target shares.

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE RelWithAssert CACHE STRING "Build type" FORCE)
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  find_program(STIG_CCACHE ccache DOC "Compiler cache, used when found")
  if(STIG_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Clones in other folders share the cache: it compares paths below this one as relative.
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${STIG_CCACHE})
  endif()
endif()

set(STIG_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined")
option(STIG_COVERAGE "Instrument for coverage" OFF)

# Most of a source's compile time goes into headers, which sources compiled together share.
option(STIG_UNITY "Compile the sources of a library several at a time" ON)
set(CMAKE_UNITY_BUILD ${STIG_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# Carries warnings and determinism flags to every target of this project, and
# nothing to its users.
add_library(stig_settings INTERFACE)
target_compile_features(stig_settings INTERFACE cxx_std_20)
target_compile_options(stig_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  # clang counts sign conversions among these, GCC does not.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
  # GCC's note on passing over-aligned structs concerns its own ABI before 4.6.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>
  # GCC 12 warns of string concatenation in the standard library itself (bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  # In a unity build sources are included, so that their own unnamed namespaces look like a header's.
  $<$<AND:$<BOOL:${STIG_UNITY}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  # Assertions name files from here: the same bytes from every clone.
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
  # The same floating-point results whatever the target processor can fuse.
  -ffp-contract=off)

# Flags that change what the linker needs; a program outside the build that links
# the installed libraries must be built with them too (tests/install_test.cmake does so).
set(STIG_INSTRUMENT "")
if(STIG_SANITIZE)
  list(APPEND STIG_INSTRUMENT -fsanitize=${STIG_SANITIZE})
  target_compile_options(stig_settings INTERFACE
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Eigen would keep a block's address before it under the address sanitizer alone, and DART, which
  # is built without, frees and hands out what Eigen allots.
  target_compile_definitions(stig_settings INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(STIG_COVERAGE)
  list(APPEND STIG_INSTRUMENT --coverage)
endif()
if(STIG_FUZZ)
  target_compile_options(stig_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()
target_compile_options(stig_settings INTERFACE ${STIG_INSTRUMENT})
target_link_options(stig_settings INTERFACE ${STIG_INSTRUMENT})
