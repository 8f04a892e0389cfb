"""Noun phrases and places on the table."""
