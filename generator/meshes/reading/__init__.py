"""Reading of foreign meshes, within limits."""
