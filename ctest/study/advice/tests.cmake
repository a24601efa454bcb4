idiophone_test(study/advice)
