idiophone_test(instruments/proxies)
