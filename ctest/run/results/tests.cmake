idiophone_test(run/results LINKS idiophone_sound_maps)
