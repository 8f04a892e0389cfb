"""What a policy sees."""
