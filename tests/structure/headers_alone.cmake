# Target headers_alone: every header of the project compiles without another one before it. One object library a room,
# so that each header is compiled with what its own room may see. Not part of the default build, whose time it would
# double: cmake --build --preset release --target headers_alone
include(rooms.cmake)

add_custom_target(headers_alone)

function(tektite_headers_alone target)
  if(NOT TARGET ${target})
    return()
  endif()
  set(sources)
  list(REMOVE_ITEM ARGN solver)
  foreach(folder IN LISTS ARGN)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
    foreach(header IN LISTS headers)
      set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp)
      file(CONFIGURE OUTPUT ${source} CONTENT "#include \"@PROJECT_SOURCE_DIR@/@header@\"\n" @ONLY)
      list(APPEND sources ${source})
    endforeach()
  endforeach()
  if(sources)
    add_library(headers_alone_${target} OBJECT EXCLUDE_FROM_ALL ${sources})
    target_link_libraries(headers_alone_${target} PRIVATE ${target})
    # What the room's libraries bring for itself alone, such as CGAL and VTK.
    target_include_directories(headers_alone_${target} SYSTEM PRIVATE
      $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_compile_options(headers_alone_${target} PRIVATE -O0)  # nothing of it is ever run
    add_dependencies(headers_alone headers_alone_${target})
  endif()
endfunction()

tektite_headers_alone(tektite_core solver/core solver/front)
tektite_headers_alone(tektite_physics solver/physics)
tektite_headers_alone(tektite_engine ${FOLDERS_engine})
tektite_headers_alone(tektite_preprocess preprocess)
tektite_headers_alone(tektite_postprocess postprocess)
