idiophone_test(proxies)
set_target_properties(test_proxies PROPERTIES UNITY_BUILD ${IDIOPHONE_UNITY} UNITY_BUILD_BATCH_SIZE 8)
