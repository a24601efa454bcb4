idiophone_test(files)
