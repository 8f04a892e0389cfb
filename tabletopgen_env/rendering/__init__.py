"""Pictures of a world: cameras, renderers, point clouds, a window."""
