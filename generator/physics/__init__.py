"""Physics of scenes: masses, convex parts, separation, placement, settling and final checks."""
