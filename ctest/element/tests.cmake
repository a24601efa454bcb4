idiophone_test(element)
