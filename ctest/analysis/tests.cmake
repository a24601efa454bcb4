idiophone_test(analysis)
