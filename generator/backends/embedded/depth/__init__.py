"""Estimation of the table's plane, and of the objects' sizes and positions, from depth maps."""
