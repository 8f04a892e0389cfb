"""The words of English: a dictionary of nouns and their kinds, and spelling."""
