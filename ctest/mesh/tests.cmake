idiophone_test(mesh RANKS 1 2 3 4)
target_include_directories(test_mesh PRIVATE ${PROJECT_SOURCE_DIR}/src/mesh) # private headers are tested too
