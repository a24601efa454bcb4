idiophone_test(solids/mesh RANKS 1 2 3 4)
target_link_libraries(test_mesh PRIVATE gmsh) # makes files for the tests
add_dependencies(test_mesh idiophone_gmsh)
