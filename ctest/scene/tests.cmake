idiophone_test(scene)
