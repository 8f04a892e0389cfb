"""Textured meshes: reading, repair, simplification, unwrapping, baking, and metric size."""
