idiophone_test(air/surface RANKS 1)
