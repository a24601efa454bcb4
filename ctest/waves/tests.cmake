idiophone_test(waves RANKS 1 3 LINKS idiophone_listening)
target_sources(test_waves PRIVATE radiation/vibrating_solid.cpp) # shapes
target_include_directories(test_waves PRIVATE radiation)
