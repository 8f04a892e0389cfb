"""Textured meshes: unwrapping, baking, repairing, reducing, and the size and mass of a thing."""
