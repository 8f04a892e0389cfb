"""Geometry of finished scenes: collisions, silhouettes and symmetry."""
