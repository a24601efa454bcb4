idiophone_test(modes RANKS 1 2 3 LINKS idiophone_test_support idiophone_petsc_environment)
