"""Training algorithms, with one protocol for those of Stable-Baselines3 and of this package."""
