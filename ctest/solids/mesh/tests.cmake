idiophone_test(solids/mesh LINKS idiophone_files idiophone_test_support)
target_link_libraries(test_mesh PRIVATE gmsh) # makes files for the tests
add_dependencies(test_mesh idiophone_gmsh)
