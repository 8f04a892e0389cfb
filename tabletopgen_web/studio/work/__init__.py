"""What the process of a job does, a module a kind."""
