"""Loaves, buns, pastries, cakes and biscuits."""
