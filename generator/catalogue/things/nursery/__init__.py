"""What children and babies play with and use."""
