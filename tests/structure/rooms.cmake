# Which room may include what and link what: the link graph of the project, as data for check_rooms.cmake.
#   FOLDERS_<room>   the folders that make it up
#   SEES_<room>      what its #include "..." may begin with
#   TARGETS_<room>   its targets
#   LINKS_<room>     the targets of this project that these may link
#   THREADS          the only folder of the engine that knows threads
#   FOREIGN_<room>   the libraries that only this room may include and link, as regular expressions
set(ROOMS core physics engine front preprocess postprocess)

set(FOLDERS_core solver/core)
set(SEES_core core/)
set(TARGETS_core tektite_core tektite_serial_hdf5)
set(LINKS_core tektite_options)

set(FOLDERS_physics solver/physics)
set(SEES_physics core/ physics/)
set(TARGETS_physics tektite_physics)
set(LINKS_physics tektite_core tektite_options)

set(ENGINE advice boundary neighbours output parallel passes run schemes stability)
list(TRANSFORM ENGINE PREPEND solver/ OUTPUT_VARIABLE FOLDERS_engine)
list(TRANSFORM ENGINE APPEND / OUTPUT_VARIABLE SEES_engine)
list(APPEND FOLDERS_engine solver)
list(APPEND SEES_engine core/ physics/)
set(THREADS solver/parallel)  # where alone of the engine loops are handed to threads, and processes are known
set(TARGETS_engine tektite_ranks tektite_engine tektite-solve)
set(LINKS_engine tektite_core tektite_physics tektite_ranks tektite_engine tektite_options tektite_serial_hdf5)

set(FOLDERS_front solver/front)
set(SEES_front core/ front/)
set(TARGETS_front tektite)
set(LINKS_front tektite_core tektite_serial_hdf5)

set(FOLDERS_preprocess preprocess)
set(SEES_preprocess core/ preprocess/ parallel/agreed.hpp parallel/checksum_by_all.hpp parallel/program_on_ranks.hpp parallel/ranks.hpp parallel/reduce.hpp parallel/sums.hpp)
set(TARGETS_preprocess tektite_preprocess tektite-preprocess)
set(LINKS_preprocess tektite_core tektite_ranks tektite_preprocess tektite_options tektite_serial_hdf5)
set(FOREIGN_preprocess CGAL)

set(FOLDERS_postprocess postprocess)
set(SEES_postprocess core/ postprocess/)
set(TARGETS_postprocess tektite_postprocess tektite-postprocess)
set(LINKS_postprocess tektite_core tektite_postprocess tektite_options tektite_serial_hdf5)
set(FOREIGN_postprocess "VTK|vtk")
