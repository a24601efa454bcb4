idiophone_test(timbre/export RANKS 1)
target_include_directories(test_export PRIVATE timbre/language)
