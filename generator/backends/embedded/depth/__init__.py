"""A depth map: the table's plane, the things on it, their sizes and places."""
