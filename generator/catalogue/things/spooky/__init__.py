"""Halloween's props and creatures."""
