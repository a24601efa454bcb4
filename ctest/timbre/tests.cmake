idiophone_test(timbre RANKS 1)
