"""Bodies and their motion: mass, convex parts, separation, placement, settling and the gate."""
