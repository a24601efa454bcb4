idiophone_test(solids/eigenmodes LINKS idiophone_test_support idiophone_petsc_environment)
target_include_directories(test_eigenmodes PRIVATE ${PROJECT_SOURCE_DIR}/ctest/solids/mesh) # bodies and files
add_dependencies(test_eigenmodes idiophone_gmsh)

# Estimated errors of 200 random bodies: a few minutes.
add_test(NAME eigenmodes.random_blocks_long COMMAND ${IDIOPHONE_MPIRUN} -n 1 $<TARGET_FILE:test_eigenmodes>
  --gtest_filter=RandomBlocks.*)
set_tests_properties(eigenmodes.random_blocks_long PROPERTIES LABELS long TIMEOUT 14400
  ENVIRONMENT "${IDIOPHONE_MPI_ENVIRONMENT};IDIOPHONE_RANDOM_BLOCKS=200")
