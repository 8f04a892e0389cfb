"""Checks of results: by their own figures, and by playing some of their episodes again."""
