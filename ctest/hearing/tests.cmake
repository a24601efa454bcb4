idiophone_test(hearing RANKS 1 2 3 LINKS idiophone_petsc_environment)
