"""Adapters from vector environments to the ``VecEnv`` interface of Stable-Baselines3."""
