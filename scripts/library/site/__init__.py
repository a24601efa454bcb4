"""The website: pages from the documentation, sounds to play, and a check of all links."""
