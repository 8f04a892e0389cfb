"""Observations of a policy."""
