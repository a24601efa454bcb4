idiophone_test(store RANKS 1 2 3 4)
