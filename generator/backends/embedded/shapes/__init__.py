"""Solids fitted to masks: boxes, extrusions, solids of revolution, and slices."""
