idiophone_test(study/contents)
target_include_directories(test_contents PRIVATE ${PROJECT_SOURCE_DIR}/src/run/results) # XDMF of impossible sizes
