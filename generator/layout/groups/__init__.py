"""Groups: rows, circles, heaps, pyramids, and place settings at seats."""
