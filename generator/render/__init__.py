"""Renderers: differentiable (torch) and software (NumPy), and helpers for pictures of scenes."""
