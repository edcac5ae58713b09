# `cpack -G DEB` in a build folder: one package of all that `cmake --install` installs, the program,
# its cases and figures, libraries, headers, and the package of Python.
set(CPACK_PACKAGE_NAME vortree)
set(CPACK_PACKAGE_VENDOR "The vortree authors")
set(CPACK_PACKAGE_CONTACT "The vortree authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Flows around bodies by a core-spreading vortex method and by SPH, sums of
velocities in O(n) to a given tolerance, and neighbors of particles of many
sizes: a program, C++ libraries with their headers, and a package of Python.")
if(VORTREE_NATIVE)
  string(APPEND CPACK_PACKAGE_DESCRIPTION "
This build is for processors like the one that built it.")
endif()
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What draws the figures; what the compiled modules are for. Libraries are added by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-h5py, python3-matplotlib, python3-numpy")
if(TARGET vortree_python)
  math(EXPR next "${VORTREE_PYTHON_MINOR} + 1")
  string(REPLACE "python3," "python3 (>= 3.${VORTREE_PYTHON_MINOR}), python3 (<< 3.${next}),"
         CPACK_DEBIAN_PACKAGE_DEPENDS "${CPACK_DEBIAN_PACKAGE_DEPENDS}")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-scipy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, paraview")

# As Debian has it: the terms in its own form, and what is installed where its Python looks.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE terms)
string(REGEX REPLACE "^[^\n]*\n+Copyright \\(c\\) ([^\n]*)\n" "" terms "${terms}")
set(owners "${CMAKE_MATCH_1}")
string(STRIP "${terms}" terms)
string(REPLACE "\n\n" "\n.\n" terms "${terms}")
string(REPLACE "\n" "\n " terms "${terms}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in ${PROJECT_BINARY_DIR}/package/copyright @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/staged.cmake.in ${PROJECT_BINARY_DIR}/package/staged.cmake
               @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_BINARY_DIR}/package/staged.cmake)
include(CPack)
