"""The grammar: a text becomes words, tokens, noun phrases and clauses, each with its place."""
