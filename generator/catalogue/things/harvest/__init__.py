"""Fruit, vegetables, herbs and nuts by the piece."""
