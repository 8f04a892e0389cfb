"""Making what the embedded vision learns from: rendered tabletops with exact ground truth."""
