idiophone_test(radiation)
