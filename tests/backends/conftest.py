"""Puts this folder on the path, so that the tests of its subfolders can share modules."""
