"""Baselines that learn: recipes, demonstrations, cloning, Stable-Baselines3, small policy files."""
