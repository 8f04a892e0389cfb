"""What trains: one protocol for the algorithms of Stable-Baselines3 and our own."""
