"""Corrections in a text, and talk that does not affect the plan."""
