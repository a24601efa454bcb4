idiophone_test(scene)
target_include_directories(test_scene PRIVATE ${PROJECT_SOURCE_DIR}/src/scene) # its private headers
