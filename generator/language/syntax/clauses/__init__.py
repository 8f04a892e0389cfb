"""Statements: lists of noun phrases, what follows each, what is said of all."""
