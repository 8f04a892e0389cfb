"""A text as words and tokens, and the small words that English goes by."""
