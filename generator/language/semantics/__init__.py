"""The meaning of clauses: objects, their positions and their relations."""
