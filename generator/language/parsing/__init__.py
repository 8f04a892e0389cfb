"""English about tabletops: words, phrases, statements and what they refer to."""
