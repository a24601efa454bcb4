idiophone_test(air/receivers RANKS 1 3)
