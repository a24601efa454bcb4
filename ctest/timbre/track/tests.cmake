idiophone_test(timbre/track RANKS 1)
target_include_directories(test_track PRIVATE timbre/language)
