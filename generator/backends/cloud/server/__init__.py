"""Chat servers: configuration, requests and answers."""
