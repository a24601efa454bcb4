idiophone_test(run/results RANKS 1 2 3 4 LINKS idiophone_sound_maps)
