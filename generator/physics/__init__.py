"""Bodies and their motion: mass, convex parts, separation, placement, settling, the gate."""
