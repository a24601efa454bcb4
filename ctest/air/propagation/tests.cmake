idiophone_test(air/propagation RANKS 1 2 3 LINKS idiophone_record idiophone_test_support idiophone_petsc_environment)
