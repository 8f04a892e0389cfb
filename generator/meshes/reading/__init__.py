"""Reading of foreign meshes, with limits."""
