idiophone_test(files RANKS 1 LINKS idiophone_contents)
