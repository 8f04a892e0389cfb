"""Clothes, jewellery, gifts and things of the bathroom."""
