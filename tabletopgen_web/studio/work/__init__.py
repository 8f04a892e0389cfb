"""The work of a job's process, one module per kind."""
