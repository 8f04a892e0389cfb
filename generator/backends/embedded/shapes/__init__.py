"""Solids that look like a mask: boxes, extrusions, rounds, slices."""
