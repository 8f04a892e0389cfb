"""The tasks, one per file, made of the goals in ``goals``."""
