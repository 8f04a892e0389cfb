"""What clauses mean: which things there are, and what is where."""
