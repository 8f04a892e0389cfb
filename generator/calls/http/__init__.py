"""One call over HTTP, within its deadline."""
