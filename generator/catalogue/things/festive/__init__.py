"""What feasts and parties bring to the table."""
