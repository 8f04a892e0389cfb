"""What the expert has been seen to solve at a bundle's table."""
