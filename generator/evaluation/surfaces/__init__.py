"""Geometry of finished scenes: collisions, silhouettes, symmetry."""
