"""Packed food: tins, jars, bags, boxes and sauces."""
