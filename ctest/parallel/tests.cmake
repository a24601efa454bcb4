idiophone_test(parallel RANKS 1 2 3 4 LINKS idiophone_deck idiophone_petsc_environment)
