"""Depth maps: the table's plane, and the objects on it with their sizes and positions."""
