idiophone_test(deck)
