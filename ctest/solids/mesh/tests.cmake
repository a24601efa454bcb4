idiophone_test(solids/mesh)
target_link_libraries(test_mesh PRIVATE gmsh) # makes files for the tests
add_dependencies(test_mesh idiophone_gmsh)
