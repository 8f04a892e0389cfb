"""Rendering of a world: cameras, renderers, point clouds, and a window."""
