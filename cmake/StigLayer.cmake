# SPDX-License-Identifier: MIT
# stig_layer(layer [USES layer…] [VENDOR target…] [VENDOR_HEADERS target…] [API header…])
#
# One library of the layer graph. A layer is named as its folder below lib/ is, physical/solver
# for example, and the library stig_physical_solver (installed: stig::physical_solver) after it.
# It has every source beside this CMakeLists, lib/ as the root of its includes, public links to
# the layers it may include, private links to vendor libraries. VENDOR_HEADERS are those that leave
# nothing to link: users of the installed library need not have them.
#
# API are the headers that are installed: those that users include, and those that these include
# in turn. All others can change without anybody outside of the project noticing.
#
# What these calls say is the layer graph: stig_write_layers hands it to
# tests/layering, which holds every #include to it, those of installed headers to what is
# installed.
function(stig_layer layer)
  cmake_parse_arguments(arg "" "" "USES;VENDOR;VENDOR_HEADERS;API" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "stig_layer(${layer}): what is '${arg_UNPARSED_ARGUMENTS}'?")
  endif()
  string(REPLACE / _ name ${layer})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_library(stig_${name} STATIC ${sources})
  add_library(stig::${name} ALIAS stig_${name})
  target_sources(stig_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/lib
                 FILES ${arg_API})
  set_target_properties(stig_${name} PROPERTIES
    EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON)
  target_compile_features(stig_${name} PUBLIC cxx_std_20)
  foreach(used IN LISTS arg_USES)
    string(REPLACE / _ used ${used})
    target_link_libraries(stig_${name} PUBLIC stig_${used})
  endforeach()
  target_link_libraries(stig_${name} PRIVATE ${arg_VENDOR})
  foreach(target IN LISTS arg_VENDOR_HEADERS ITEMS stig_settings)
    target_link_libraries(stig_${name} PRIVATE $<BUILD_INTERFACE:${target}>)
  endforeach()
  set_property(GLOBAL APPEND PROPERTY STIG_LAYERS ${layer})
  set_property(GLOBAL PROPERTY STIG_LAYER_USES_${layer} "${arg_USES}")
  set_property(GLOBAL PROPERTY STIG_LAYER_VENDOR_${layer} "${arg_VENDOR};${arg_VENDOR_HEADERS}")
  set_property(GLOBAL PROPERTY STIG_LAYER_API_${layer} "${arg_API}")
endfunction()

# Writes the graph, a line for each layer: "name | layers it uses | vendor targets | installed
# headers".
function(stig_write_layers path)
  get_property(layers GLOBAL PROPERTY STIG_LAYERS)
  set(text "")
  foreach(layer IN LISTS layers)
    get_property(uses GLOBAL PROPERTY STIG_LAYER_USES_${layer})
    get_property(vendor GLOBAL PROPERTY STIG_LAYER_VENDOR_${layer})
    get_property(api GLOBAL PROPERTY STIG_LAYER_API_${layer})
    list(REMOVE_ITEM vendor "")
    list(JOIN uses " " uses)
    list(JOIN vendor " " vendor)
    list(JOIN api " " api)
    string(APPEND text "${layer} | ${uses} | ${vendor} | ${api}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${path} CONTENT "${text}" @ONLY)
endfunction()
