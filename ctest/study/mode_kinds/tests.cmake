idiophone_test(study/mode_kinds)
