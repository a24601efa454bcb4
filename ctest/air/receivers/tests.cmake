idiophone_test(air/receivers)
