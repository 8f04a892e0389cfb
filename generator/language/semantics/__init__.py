"""Semantics of clauses: objects, and their positions and relations."""
