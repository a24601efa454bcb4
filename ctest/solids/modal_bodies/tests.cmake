idiophone_test(solids/modal_bodies)
