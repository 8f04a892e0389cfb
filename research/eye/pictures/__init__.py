"""Rendering of the eye's training pictures."""
