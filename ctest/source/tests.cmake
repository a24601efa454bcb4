idiophone_test(source RANKS 1 2 3 LINKS idiophone_petsc_environment)
add_dependencies(test_source idiophone_gmsh)
