"""Where and how to take, put down and push, before anything moves."""
