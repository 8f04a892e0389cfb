"""Image models: what is asked of them, and what is cut from their answers."""
