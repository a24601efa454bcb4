idiophone_test(instruments/drivers)
