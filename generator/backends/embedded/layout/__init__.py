"""Supports, positions and yaws of objects, measured or estimated."""
