idiophone_test(solids/eigenmodes LINKS idiophone_test_support idiophone_petsc_environment)
target_include_directories(test_eigenmodes PRIVATE ${PROJECT_SOURCE_DIR}/ctest/solids/mesh) # bodies and files
add_dependencies(test_eigenmodes idiophone_gmsh)

# Estimated errors of 200 random bodies: a few minutes.
add_test(NAME eigenmodes.random_blocks_long COMMAND ${IDIOPHONE_MPIRUN} -n 1 $<TARGET_FILE:test_eigenmodes>
  --gtest_filter=RandomBlocks.*)
set_tests_properties(eigenmodes.random_blocks_long PROPERTIES LABELS long TIMEOUT 14400
  ENVIRONMENT "${IDIOPHONE_MPI_ENVIRONMENT};IDIOPHONE_RANDOM_BLOCKS=200")

# Bounds of 1000 random boxes: a few minutes.
add_test(NAME eigenmodes.bounds_of_boxes_long COMMAND ${IDIOPHONE_MPIRUN} -n 1 $<TARGET_FILE:test_eigenmodes>
  --gtest_filter=FrequencyBounds.EncloseTheFrequenciesOfRandomBoxes)
set_tests_properties(eigenmodes.bounds_of_boxes_long PROPERTIES LABELS long TIMEOUT 14400
  ENVIRONMENT "${IDIOPHONE_MPI_ENVIRONMENT};IDIOPHONE_RANDOM_BOXES=1000")
