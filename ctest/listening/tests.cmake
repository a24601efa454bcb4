idiophone_test(listening RANKS 1 3)
