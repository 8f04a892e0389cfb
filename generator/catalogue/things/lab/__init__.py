"""Laboratory and clinic."""
