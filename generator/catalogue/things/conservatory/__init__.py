"""House plants by their kind, in pots."""
