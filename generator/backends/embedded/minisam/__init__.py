"""Outlines by a promptable model that the user downloads; the eye gives table, camera and names."""
