"""Things to cook and to eat with."""
