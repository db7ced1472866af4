# SPDX-License-Identifier: MIT
# What cpack makes of an installed tree: a tarball of all of it, which finds its own files wherever it is
# unpacked, and Debian packages, one for each component. Packages go into packages/ of the build.
#
#   cpack -G TGZ      cpack -G DEB      cpack -G DEB -D CPACK_COMPONENTS_ALL=program
set(CPACK_PACKAGE_VENDOR "The stigc authors")
set(CPACK_PACKAGE_CONTACT "The stigc authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_GENERATOR TGZ)
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL program lattice dev)
foreach(part IN ITEMS mesh mpi)
  if(TARGET stigc-${part})
    list(APPEND CPACK_COMPONENTS_ALL ${part})
  endif()
endforeach()
if(TARGET stigc_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# Names as Debian has them. Programs depend on the libraries that dpkg-shlibdeps finds them linked to.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME stigc)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "rules, proofs and physics for collective construction")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg")
foreach(part IN ITEMS MESH MPI PYTHON)
  string(TOLOWER ${part} name)
  set(CPACK_DEBIAN_${part}_PACKAGE_NAME stigc-${name})
  set(CPACK_DEBIAN_${part}_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_${part}_PACKAGE_DEPENDS "stigc (= ${PROJECT_VERSION})")
endforeach()
string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS ", python3, python3-numpy")
set(CPACK_COMPONENT_MESH_DESCRIPTION "meshes for stigc, by CGAL and under the GPL")
set(CPACK_COMPONENT_MPI_DESCRIPTION "studies of stigc on clusters, by MPI")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "the module of stigc for Python")

# The libraries are static: what they link, find_package(stig) looks for.
set(CPACK_DEBIAN_LATTICE_PACKAGE_NAME libstig-lattice-dev)
set(CPACK_DEBIAN_LATTICE_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_LATTICE_DESCRIPTION "stig's libraries but those of physics")
string(JOIN ", " CPACK_DEBIAN_LATTICE_PACKAGE_DEPENDS libtbb-dev libfmt-dev libyaml-cpp-dev
       zlib1g-dev libpugixml-dev pkg-config libzstd-dev libcairo2-dev libsqlite3-dev liblua5.4-dev
       libcadical-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libstig-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DESCRIPTION "all of stig's libraries")
string(JOIN ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libstig-lattice-dev (= ${PROJECT_VERSION})"
       libdart-dev libcpp-httplib-dev)
include(CPack)
