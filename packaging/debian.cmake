# Debian packages by `cpack`: tektite, the programs, and libtektite-dev, the solver as a library.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL programs library)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The tektite developers")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME tektite)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "high-velocity impact of solids with smoothed particle hydrodynamics
 Takes a scene, a text file with bodies, materials and an impact, to measured
 numbers, files for ParaView and pictures.")
# The libraries that the programs are linked with are found by dpkg-shlibdeps; charts of studies need a private X server.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "xvfb, xauth, libgl1-mesa-dri")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtektite-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "solver of tektite as a static library
 Schemes of smoothed particle hydrodynamics for impact, to be used from C++ with
 find_package(tektite).")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libboost-program-options-dev, libeigen3-dev, libfmt-dev, libhdf5-dev, \
libhdf5-openmpi-dev, libopenmpi-dev, libspdlog-dev, libtomlplusplus-dev, libtrilinos-zoltan-dev, \
zlib1g-dev")
include(CPack)
