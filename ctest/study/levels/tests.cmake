idiophone_test(study/levels)
