idiophone_test(study/contents RANKS 1)
