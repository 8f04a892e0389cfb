"""Corrections in a text, and remarks that do not affect the plan."""
