"""Pages in Debian's Chromium: for benchmarks, for tests, and for the pictures of the docs."""
