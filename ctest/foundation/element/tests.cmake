idiophone_test(foundation/element)
