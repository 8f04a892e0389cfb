"""A single HTTP call that ends by its deadline."""
