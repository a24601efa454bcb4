idiophone_test(timbre/language)
