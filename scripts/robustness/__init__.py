"""The kinds of trials of scripts/torment."""
