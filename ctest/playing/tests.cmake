idiophone_test(playing)
