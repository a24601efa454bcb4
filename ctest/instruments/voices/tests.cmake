idiophone_test(instruments/voices)
