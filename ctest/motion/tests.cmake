idiophone_test(motion RANKS 1 LINKS idiophone_test_support)
