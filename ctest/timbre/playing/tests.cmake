idiophone_test(timbre/playing RANKS 1)
