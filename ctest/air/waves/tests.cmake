idiophone_test(air/waves LINKS idiophone_receivers idiophone_harmonic)
target_sources(test_waves PRIVATE air/radiation/vibrating_solid.cpp) # shapes
target_include_directories(test_waves PRIVATE air/radiation)
