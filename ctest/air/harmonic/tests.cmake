idiophone_test(air/harmonic LINKS idiophone_receivers)
target_sources(test_harmonic PRIVATE air/radiation/vibrating_solid.cpp) # spheres and discs
target_include_directories(test_harmonic PRIVATE air/radiation)
