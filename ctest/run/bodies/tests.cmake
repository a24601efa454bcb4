idiophone_test(run/bodies RANKS 1 2 3 LINKS idiophone_record idiophone_petsc_environment)
add_dependencies(test_bodies idiophone_gmsh)
