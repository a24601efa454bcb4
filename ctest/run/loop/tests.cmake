idiophone_test(run/loop RANKS 1)
