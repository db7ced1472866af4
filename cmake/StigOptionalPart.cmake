# SPDX-License-Identifier: MIT
# Parts that are left out where something is lacking, unless the cache variable of the part is ON.

# Declares the part's variable: AUTO, ON or OFF. Ends the file that calls it when it is OFF.
macro(stig_optional_part variable part)
  set(${variable} AUTO CACHE STRING "Build ${part}: AUTO (where it can be), ON or OFF")
  set_property(CACHE ${variable} PROPERTY STRINGS AUTO ON OFF)
  if(NOT ${variable})
    return()
  endif()
endmacro()

# Ends the file that calls it when something is lacking; with an error where the part must be built.
macro(stig_lacking variable part lacking)
  if(NOT "${lacking}" STREQUAL "")
    if(${variable} STREQUAL AUTO)
      message(STATUS "Without ${part}: ${lacking}")
      return()
    endif()
    message(FATAL_ERROR "${variable} is ON, but ${lacking}")
  endif()
endmacro()
