# SPDX-License-Identifier: MIT
# What an installed tree holds: bin/stigc, the libraries and the headers that each names as its
# API, share/stig/rulesets, blocks, robots, programs and scenes, share/stig/schema, and what
# find_package(stig) needs.
include(CMakePackageConfigHelpers)

set(STIG_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/stig)
set(STIG_INSTALL_DATADIR ${CMAKE_INSTALL_DATADIR}/stig)

get_property(stig_layers GLOBAL PROPERTY STIG_LAYERS)
list(TRANSFORM stig_layers REPLACE / _)
list(TRANSFORM stig_layers PREPEND stig_)
install(TARGETS ${stig_layers} EXPORT stigTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stig)
install(EXPORT stigTargets NAMESPACE stig:: DESTINATION ${STIG_INSTALL_CMAKEDIR})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/stigConfig.cmake.in ${PROJECT_BINARY_DIR}/stigConfig.cmake
  INSTALL_DESTINATION ${STIG_INSTALL_CMAKEDIR} PATH_VARS STIG_INSTALL_DATADIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/stigConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/stigConfig.cmake
              ${PROJECT_BINARY_DIR}/stigConfigVersion.cmake
        DESTINATION ${STIG_INSTALL_CMAKEDIR})

install(TARGETS stigc RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/rulesets ${PROJECT_SOURCE_DIR}/blocks
                  ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/robots
                  ${PROJECT_SOURCE_DIR}/programs ${PROJECT_SOURCE_DIR}/plans ${PROJECT_SOURCE_DIR}/studies
        DESTINATION ${STIG_INSTALL_DATADIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The schema is what the program itself says it is. It is written when installing, so that
# nothing but the program need be built for that.
set(STIG_SCHEMA ${PROJECT_BINARY_DIR}/schema/ruleset-1.json)
install(CODE "
  file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/schema\")
  execute_process(COMMAND \"$<TARGET_FILE:stigc>\" schema OUTPUT_FILE \"${STIG_SCHEMA}\"
                  COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${STIG_SCHEMA} DESTINATION ${STIG_INSTALL_DATADIR}/schema)

set(CPACK_PACKAGE_VENDOR "The stigc authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_GENERATOR TGZ)
include(CPack)
