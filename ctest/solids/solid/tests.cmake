idiophone_test(solids/solid LINKS idiophone_test_support)
