idiophone_test(instruments/score)
