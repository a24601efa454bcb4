idiophone_test(study/contents)
