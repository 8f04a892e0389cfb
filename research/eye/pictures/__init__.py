"""The pictures that the eye learns from, rendered."""
