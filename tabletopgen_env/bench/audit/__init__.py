"""Checks of results: plausibility of their figures, and replay of some of their episodes."""
