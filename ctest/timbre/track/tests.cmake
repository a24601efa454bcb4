idiophone_test(timbre/track)
target_include_directories(test_track PRIVATE timbre/language)
