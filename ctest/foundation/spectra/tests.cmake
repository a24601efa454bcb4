idiophone_test(foundation/spectra)
