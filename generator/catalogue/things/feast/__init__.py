"""Sweets, street food and dishes from many kitchens."""
