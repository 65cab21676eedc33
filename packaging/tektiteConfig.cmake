# find_package(tektite): the target tektite::solver, and tektite::core for scenes and particle files
# alone, together with tektite::serial_hdf5.
include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(spdlog)
find_dependency(Eigen3)
find_dependency(Boost COMPONENTS program_options)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(Threads)
find_dependency(ZLIB)
find_package(MPI COMPONENTS CXX QUIET)  # the library needs it where it was built with it
include(${CMAKE_CURRENT_LIST_DIR}/tektiteTargets.cmake)
