"""Mass, convex parts, separation, placement, settling and the physical gate of bodies."""
