idiophone_test(timbre/nodes LINKS idiophone_language)
target_include_directories(test_nodes PRIVATE timbre/language)
