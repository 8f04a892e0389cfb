"""Checks of results: detection of impossible values, and replay of some episodes."""
