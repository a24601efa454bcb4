idiophone_test(instruments/sound_maps LINKS idiophone_receivers idiophone_contents idiophone_petsc_environment)
target_sources(test_sound_maps PRIVATE air/radiation/vibrating_solid.cpp) # spheres and discs
target_include_directories(test_sound_maps PRIVATE air/radiation)
add_dependencies(test_sound_maps idiophone_gmsh) # meshes of membranes and plates
