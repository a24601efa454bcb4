idiophone_test(store RANKS 1 2 3 4)
target_include_directories(test_store PRIVATE support)
