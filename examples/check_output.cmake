# SPDX-License-Identifier: MIT
# Runs a program and compares what it prints with a file:
#
#   cmake -D "RUN=program;argument…" -D EXPECTED=file -P check_output.cmake
execute_process(COMMAND ${RUN} OUTPUT_VARIABLE output RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "failed with ${status}, after:\n${output}")
endif()
file(READ ${EXPECTED} expected)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "${EXPECTED} has:\n${expected}\nwhere the program printed:\n${output}")
endif()
