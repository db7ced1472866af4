# SPDX-License-Identifier: MIT
# Installs the build into an empty prefix, runs the installed program, then configures,
# builds and runs the examples against that prefix alone.
#
#   cmake -D BUILD=… -D WORK=… -D COMPILER=… -D FLAGS=… -P install_test.cmake
foreach(name IN ITEMS BUILD WORK COMPILER)
  if(NOT ${name})
    message(FATAL_ERROR "-D ${name}=… is missing")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " words "${ARGN}")
    message(FATAL_ERROR "failed with ${status}: ${words}")
  endif()
endfunction()

# A build of the program alone, as README has it, holds no schema.
file(REMOVE_RECURSE ${WORK} ${BUILD}/schema)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${WORK}/prefix/bin/stigc check ${WORK}/prefix/share/stig/rulesets/staircase.yaml)
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/../examples -B ${WORK}/build
    -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-on-failure --no-tests=error)
