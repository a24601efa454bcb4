idiophone_test(timbre/evolution RANKS 1)
target_include_directories(test_evolution PRIVATE timbre/language)
