idiophone_test(study/mode_pictures)
