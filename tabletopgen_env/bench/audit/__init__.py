"""Checks of results: whether their values are possible, and replay of some episodes."""
