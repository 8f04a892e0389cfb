"""Things of desks."""
