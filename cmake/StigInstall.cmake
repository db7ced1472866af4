# SPDX-License-Identifier: MIT
# What an installed tree holds: bin/stigc, the libraries and the headers that each names as its
# API, share/stig/rulesets, blocks, robots, programs and scenes, share/stig/schema, and what
# find_package(stig) needs. The components are those of packages (StigPackages.cmake): program, mesh,
# mpi, python; lattice for the libraries without physics, and dev for the rest of them.
include(CMakePackageConfigHelpers)

set(STIG_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/stig)
set(STIG_INSTALL_DATADIR ${CMAKE_INSTALL_DATADIR}/stig)

# Layers are declared after those that they use, so that one pass finds all that need DART.
get_property(stig_layers GLOBAL PROPERTY STIG_LAYERS)
set(stig_with_dart "")
foreach(layer IN LISTS stig_layers)
  get_property(uses GLOBAL PROPERTY STIG_LAYER_USES_${layer})
  get_property(vendors GLOBAL PROPERTY STIG_LAYER_VENDOR_${layer})
  set(component lattice)
  foreach(used IN LISTS uses)
    if(used IN_LIST stig_with_dart)
      set(component dev)
    endif()
  endforeach()
  if(dart IN_LIST vendors)
    set(component dev)
  endif()
  set(export stigLatticeTargets)
  if(component STREQUAL dev)
    list(APPEND stig_with_dart ${layer})
    set(export stigTargets)
  endif()
  string(REPLACE / _ name ${layer})
  install(TARGETS stig_${name} EXPORT ${export}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stig COMPONENT ${component})
endforeach()
install(EXPORT stigLatticeTargets NAMESPACE stig:: DESTINATION ${STIG_INSTALL_CMAKEDIR}
        COMPONENT lattice)
install(EXPORT stigTargets NAMESPACE stig:: DESTINATION ${STIG_INSTALL_CMAKEDIR} COMPONENT dev)

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/stigConfig.cmake.in ${PROJECT_BINARY_DIR}/stigConfig.cmake
  INSTALL_DESTINATION ${STIG_INSTALL_CMAKEDIR} PATH_VARS STIG_INSTALL_DATADIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/stigConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/stigConfig.cmake
              ${PROJECT_BINARY_DIR}/stigConfigVersion.cmake
        DESTINATION ${STIG_INSTALL_CMAKEDIR} COMPONENT lattice)

install(TARGETS stigc RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/rulesets ${PROJECT_SOURCE_DIR}/blocks
                  ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/robots
                  ${PROJECT_SOURCE_DIR}/programs ${PROJECT_SOURCE_DIR}/plans ${PROJECT_SOURCE_DIR}/studies
        DESTINATION ${STIG_INSTALL_DATADIR} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# The schema is what the program itself says it is. It is written when installing, so that
# nothing but the program need be built for that.
set(STIG_SCHEMA ${PROJECT_BINARY_DIR}/schema/ruleset-1.json)
install(CODE "
  file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/schema\")
  execute_process(COMMAND \"$<TARGET_FILE:stigc>\" schema OUTPUT_FILE \"${STIG_SCHEMA}\"
                  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
install(FILES ${STIG_SCHEMA} DESTINATION ${STIG_INSTALL_DATADIR}/schema COMPONENT program)

include(StigPackages)
