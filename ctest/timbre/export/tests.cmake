idiophone_test(timbre/export)
target_include_directories(test_export PRIVATE timbre/language)
