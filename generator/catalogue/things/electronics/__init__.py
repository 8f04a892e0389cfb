"""Electric things."""
