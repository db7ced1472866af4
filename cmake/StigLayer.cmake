# SPDX-License-Identifier: MIT
# stig_layer(name USES layer… [VENDOR target…])
#
# One library of the layer graph: every source beside this CMakeLists, its headers
# as a file set rooted at lib/, public links to the layers it may include, private
# links to vendor libraries. The graph in these calls is the one that
# tests/layering checks includes against.
function(stig_layer name)
  cmake_parse_arguments(arg "" "" "USES;VENDOR" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  file(GLOB headers CONFIGURE_DEPENDS *.h *.def)
  add_library(stig_${name} STATIC ${sources})
  add_library(stig::${name} ALIAS stig_${name})
  target_sources(stig_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/lib
                 FILES ${headers})
  set_target_properties(stig_${name} PROPERTIES EXPORT_NAME ${name}
                        POSITION_INDEPENDENT_CODE ON)
  target_compile_features(stig_${name} PUBLIC cxx_std_20)
  foreach(layer IN LISTS arg_USES)
    target_link_libraries(stig_${name} PUBLIC stig_${layer})
  endforeach()
  target_link_libraries(stig_${name} PRIVATE ${arg_VENDOR} $<BUILD_INTERFACE:stig_settings>)
  set_property(GLOBAL APPEND PROPERTY STIG_LAYERS stig_${name})
endfunction()
