idiophone_test(instruments/outputs)
