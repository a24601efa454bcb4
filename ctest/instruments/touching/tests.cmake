idiophone_test(instruments/touching)
