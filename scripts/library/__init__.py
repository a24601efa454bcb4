"""The functions that the programs in scripts/ and tools/ share."""
