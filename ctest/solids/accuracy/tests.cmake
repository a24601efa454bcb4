idiophone_test(solids/accuracy)
