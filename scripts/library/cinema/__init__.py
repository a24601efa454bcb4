"""What scripts/movie is made of: result, surface, obstacles, stage, camera and film."""
