"""Fruit, vegetables, herbs and spices that a greengrocer sells besides the common ones."""
