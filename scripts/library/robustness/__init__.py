"""The kinds of trials of tools/torment."""
