idiophone_test(hearing RANKS 1 2 3 LINKS idiophone_petsc_environment)
target_include_directories(test_hearing PRIVATE support)
