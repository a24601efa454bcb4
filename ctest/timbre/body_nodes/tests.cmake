idiophone_test(timbre/body_nodes)
