idiophone_test(foundation/friction)
