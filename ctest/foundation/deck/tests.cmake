idiophone_test(foundation/deck)
