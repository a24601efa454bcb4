idiophone_test(foundation/dense)
