"""Texts with the expected content of their tables, and its evaluation on bundles."""
