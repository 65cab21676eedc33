# tektite_add_test(NAME <name> LABEL <label> SOURCES <file>... [LIBRARIES <target>...] [DEFINITIONS <definition>...])
#
# One Catch2 test binary <name>, built into tests/ of the build tree. Each of its cases becomes a test of ctest, named
# after the case and labelled <label>: unit, verification, validation, stability or robustness.
find_package(Catch2 2.13 REQUIRED)
include(Catch)

add_library(tektite_test_main OBJECT ${CMAKE_CURRENT_LIST_DIR}/main.cpp)
target_link_libraries(tektite_test_main PUBLIC Catch2::Catch2)

function(tektite_add_test)
  cmake_parse_arguments(TEST "" "NAME;LABEL" "SOURCES;LIBRARIES;DEFINITIONS" ${ARGN})
  if(NOT TEST_NAME OR NOT TEST_SOURCES OR TEST_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tektite_add_test: NAME and SOURCES are needed; not understood: ${TEST_UNPARSED_ARGUMENTS}")
  endif()
  set(labels unit verification validation stability robustness)
  if(NOT TEST_LABEL IN_LIST labels)
    message(FATAL_ERROR "tektite_add_test: LABEL of ${TEST_NAME} is \"${TEST_LABEL}\", not one of ${labels}")
  endif()
  add_executable(${TEST_NAME} ${TEST_SOURCES})
  set_target_properties(${TEST_NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${TEST_NAME} PRIVATE tektite_test_main ${TEST_LIBRARIES})
  target_include_directories(${TEST_NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${TEST_NAME} PRIVATE ${TEST_DEFINITIONS})
  # Threads that wait give their core away: tests run beside each other, and on machines that do other things too.
  catch_discover_tests(${TEST_NAME} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${TEST_LABEL} ENVIRONMENT OMP_WAIT_POLICY=passive)
endfunction()
