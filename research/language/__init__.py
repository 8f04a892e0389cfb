"""The planner's English vocabulary, extracted from WordNet; not part of the distribution."""
