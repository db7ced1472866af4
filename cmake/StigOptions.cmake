# SPDX-License-Identifier: MIT
# Compile settings that every target shares.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE RelWithAssert CACHE STRING "Build type" FORCE)
endif()
# Optimised, assertions on: what tests and daily work use.
set(CMAKE_CXX_FLAGS_RELWITHASSERT "-O2" CACHE STRING "")

find_program(STIG_CCACHE ccache)
if(STIG_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${STIG_CCACHE})
endif()

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(STIG_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined")
option(STIG_COVERAGE "Instrument for coverage" OFF)

# Carries warnings and determinism flags to every target of this project, and
# nothing to its users.
add_library(stig_settings INTERFACE)
target_compile_features(stig_settings INTERFACE cxx_std_20)
target_compile_options(stig_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  -Wno-psabi -ffp-contract=off)
if(STIG_SANITIZE)
  target_compile_options(stig_settings INTERFACE
    -fsanitize=${STIG_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(stig_settings INTERFACE -fsanitize=${STIG_SANITIZE})
endif()
if(STIG_COVERAGE)
  target_compile_options(stig_settings INTERFACE --coverage)
  target_link_options(stig_settings INTERFACE --coverage)
endif()
