"""What tools/slurm_trial consists of."""
