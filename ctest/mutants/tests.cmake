# Mutants of every type of file, read in this process's children. docs/method/robustness.md says how to make more of them.
file(GLOB mutants_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/mutants/*.cpp)
add_executable(test_mutants ${mutants_tests})
idiophone_unity(test_mutants)
target_link_libraries(test_mutants PRIVATE idiophone_fitting idiophone_contents idiophone_evolution idiophone_export idiophone_track idiophone_voices gmsh GTest::gtest_main GTest::gmock idiophone_flags)
target_include_directories(test_mutants PRIVATE scene solids/mesh support ${PROJECT_SOURCE_DIR}/src/solids/mesh)
target_compile_definitions(test_mutants PRIVATE IDIOPHONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(test_mutants idiophone_gmsh)
gtest_discover_tests(test_mutants TEST_PREFIX mutants. DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT "${IDIOPHONE_MPI_ENVIRONMENT}")
