"""English vocabulary: a dictionary of nouns and their families, and spelling correction."""
