"""What is thrown away: wrappers, peels, ends and scraps."""
