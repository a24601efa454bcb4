idiophone_test(proxies)
