idiophone_test(air/surface)
