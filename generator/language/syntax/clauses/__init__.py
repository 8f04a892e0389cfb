"""Clauses: lists of noun phrases, their modifiers, and predicates."""
