"""Learned baselines: recipes, demonstrations, cloning, Stable-Baselines3 and policy files."""
