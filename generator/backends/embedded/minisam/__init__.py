"""Outlines by a promptable model that the user downloads; the detector finds everything else."""
