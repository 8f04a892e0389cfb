"""Training algorithms of Stable-Baselines3 and of this package, behind one protocol."""
