"""Meshes from elsewhere, read within bounds."""
