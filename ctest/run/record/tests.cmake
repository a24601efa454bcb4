idiophone_test(run/record RANKS 1 2 3 LINKS idiophone_petsc_environment)
add_dependencies(test_record idiophone_gmsh)
