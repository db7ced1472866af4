# SPDX-License-Identifier: MIT
# Packs the program, unpacks it elsewhere, and runs it there: the Debian package in an empty root, where
# dpkg-shlibdeps is found, and a tarball in two places, from a folder that has nothing to do with either.
# The libraries without physics are found by a project for which there is no DART.
#
#   cmake -D BUILD=… -D WORK=… -D SHLIBDEPS=… -P package_test.cmake
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                  OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " words "${ARGN}")
    message(FATAL_ERROR "failed with ${status}: ${words}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

# Runs what was unpacked, which must read its own files.
function(try root)
  run(${root}/bin/stigc explore rulesets/staircase.yaml --seed 1)
  if(NOT said MATCHES "reading ${root}/share/stig/rulesets/staircase.yaml")
    message(FATAL_ERROR "other files were read than those in ${root}:\n${said}")
  endif()
  run(${root}/bin/stigc simulate scenes/stack.yaml --duration 0.1)
  run(${root}/bin/stigc validate --help)
  run(${root}/bin/stigc doctor rulesets/staircase.yaml)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/here ${WORK}/there)
set(pack ${CPACK} --config ${BUILD}/CPackConfig.cmake -B ${WORK}/packages)
run(${pack} -G TGZ)
file(GLOB tarball ${WORK}/packages/*.tar.gz)
foreach(place IN ITEMS here there)
  run(${CMAKE_COMMAND} -E chdir ${WORK}/${place} ${CMAKE_COMMAND} -E tar xf ${tarball})
  file(GLOB root ${WORK}/${place}/*)
  try(${root})
endforeach()

if(SHLIBDEPS)
  run(${pack} -G DEB -D CPACK_COMPONENTS_ALL=program)
  file(GLOB package ${WORK}/packages/stigc_*.deb)
  run(dpkg-deb -x ${package} ${WORK}/root)
  try(${WORK}/root/usr)
  run(dpkg-deb -f ${package} Depends)
  if(NOT said MATCHES "libdart" OR NOT said MATCHES "libyaml-cpp")
    message(FATAL_ERROR "what the package depends on was not found out: ${said}")
  endif()

  run(${pack} -G DEB -D CPACK_COMPONENTS_ALL=lattice)
  file(GLOB package ${WORK}/packages/libstig-lattice-dev_*.deb)
  run(dpkg-deb -x ${package} ${WORK}/lattice)
  file(WRITE ${WORK}/use/CMakeLists.txt
       "cmake_minimum_required(VERSION 3.25)\nproject(use CXX)\n"
       "find_package(stig REQUIRED COMPONENTS verify synthesis compiler)\n")
  run(${CMAKE_COMMAND} -G Ninja -S ${WORK}/use -B ${WORK}/use/build
      -D CMAKE_PREFIX_PATH=${WORK}/lattice/usr -D CMAKE_DISABLE_FIND_PACKAGE_DART=ON
      -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
endif()
