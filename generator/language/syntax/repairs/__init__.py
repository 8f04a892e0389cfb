"""What a text takes back, and what it only tells."""
