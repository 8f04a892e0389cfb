"""Robots and boards for their tests, what films and records, props."""
