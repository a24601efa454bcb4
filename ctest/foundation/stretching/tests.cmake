idiophone_test(foundation/stretching)
