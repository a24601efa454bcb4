idiophone_test(surface RANKS 1)
