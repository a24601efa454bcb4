idiophone_test(modal RANKS 1 3 LINKS idiophone_listening)
target_sources(test_modal PRIVATE ${PROJECT_SOURCE_DIR}/ctest/radiation/vibrating_solid.cpp) # spheres and discs
target_include_directories(test_modal PRIVATE ${PROJECT_SOURCE_DIR}/ctest/radiation)
