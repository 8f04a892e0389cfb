"""Renderers: differentiable (torch), software (NumPy), and helpers for pictures of scenes."""
