"""Packed groceries, and the things on a shop's counter."""
