idiophone_test(timbre/playing)
