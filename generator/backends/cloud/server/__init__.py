"""Chat servers: settings, questions sent, answers read."""
