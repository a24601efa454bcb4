idiophone_test(hearing RANKS 1 2 3 LINKS idiophone_test_support idiophone_petsc_environment)
