"""What the planner knows of English, made of WordNet; not part of the distribution."""
