idiophone_test(study/report)
