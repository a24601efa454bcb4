idiophone_test(run/loop)
