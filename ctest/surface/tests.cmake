idiophone_test(surface)
