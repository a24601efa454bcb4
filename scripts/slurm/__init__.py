"""What scripts/slurm_trial consists of."""
