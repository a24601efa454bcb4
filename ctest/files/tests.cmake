idiophone_test(files LINKS idiophone_contents)
