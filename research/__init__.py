"""Training of the shipped models and tables; not part of the distribution."""
