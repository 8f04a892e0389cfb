"""Corrections in a text, and talk without a meaning for the plan."""
