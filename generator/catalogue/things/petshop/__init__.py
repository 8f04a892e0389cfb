"""Small pets, and what their keepers buy for them."""
