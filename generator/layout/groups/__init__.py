"""Things arranged as one: rows, circles, heaps, pyramids, and settings at seats."""
