idiophone_test(timbre/nodes RANKS 1 LINKS idiophone_language)
target_include_directories(test_nodes PRIVATE timbre/language)
