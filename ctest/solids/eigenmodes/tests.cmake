idiophone_test(solids/eigenmodes LINKS idiophone_test_support idiophone_petsc_environment)
target_include_directories(test_eigenmodes PRIVATE ${PROJECT_SOURCE_DIR}/ctest/solids/mesh) # bodies and files
add_dependencies(test_eigenmodes idiophone_gmsh)
