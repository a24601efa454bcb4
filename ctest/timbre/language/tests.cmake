idiophone_test(timbre/language RANKS 1)
