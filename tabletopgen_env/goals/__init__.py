"""Goals: conditions, sampling, and instructions."""
