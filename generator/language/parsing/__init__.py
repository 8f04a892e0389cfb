"""Vocabulary and lexicon of tabletop descriptions."""
