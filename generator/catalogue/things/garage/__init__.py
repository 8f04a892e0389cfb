"""Out of the garage: parts of engines and of a car, and what serves them."""
