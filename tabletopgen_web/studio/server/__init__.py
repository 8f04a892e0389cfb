"""The HTTP server: access control, request limits, and error responses."""
