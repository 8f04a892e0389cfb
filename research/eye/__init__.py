"""Training of the embedded vision on rendered tabletops with exact ground truth."""
