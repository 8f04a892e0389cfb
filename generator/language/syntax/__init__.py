"""Grammar: from text to words, tokens, noun phrases and clauses, each with its span."""
