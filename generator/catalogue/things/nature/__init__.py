"""Flowers, finds from outdoors, and what a garden needs."""
