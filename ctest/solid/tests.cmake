idiophone_test(solid LINKS idiophone_test_support)
target_include_directories(test_solid PRIVATE ${PROJECT_SOURCE_DIR}/src/solid) # private headers are tested too
