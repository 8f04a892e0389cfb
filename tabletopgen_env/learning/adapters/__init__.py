"""Vector environments as Stable-Baselines3 has them."""
