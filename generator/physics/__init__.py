"""Bodies and their motion: mass, convex parts, separation, seating, settling, the gate."""
