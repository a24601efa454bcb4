idiophone_test(modes RANKS 1 2 3 LINKS idiophone_test_support idiophone_petsc_environment)
target_include_directories(test_modes PRIVATE ${PROJECT_SOURCE_DIR}/ctest/mesh) # bodies and files
add_dependencies(test_modes idiophone_gmsh)
