"""Generation of fresh tables in separate processes."""
