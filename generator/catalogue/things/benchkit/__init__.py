"""Robots and boards for their tests, and devices of several kinds."""
