"""Segmentation by a downloadable promptable model (the outlines) and the detector (the rest)."""
