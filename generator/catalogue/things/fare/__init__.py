"""Bread, sweets, meat, seafood and dishes ready to eat."""
