"""Puts this folder on the path, so that its folders' tests can share what is in it."""
