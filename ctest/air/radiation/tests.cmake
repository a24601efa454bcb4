idiophone_test(air/radiation LINKS idiophone_receivers)
