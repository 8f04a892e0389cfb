"""Training of what the packages ship; not part of the distribution."""
