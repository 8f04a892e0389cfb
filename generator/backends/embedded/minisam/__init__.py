"""Segmentation with a downloadable promptable model for outlines, and the detector for the rest."""
