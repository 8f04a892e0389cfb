"""Renderers: differentiable (torch), software (NumPy), and pictures made with them."""
