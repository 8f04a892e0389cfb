"""Training algorithms, with one protocol for Stable-Baselines3 and this package's own."""
