"""Noun phrases and zones of the table."""
