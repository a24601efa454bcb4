idiophone_test(instruments/sound_maps LINKS idiophone_receivers idiophone_contents)
target_sources(test_sound_maps PRIVATE air/radiation/vibrating_solid.cpp) # spheres and discs
target_include_directories(test_sound_maps PRIVATE air/radiation)
