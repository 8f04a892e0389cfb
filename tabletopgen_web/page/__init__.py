"""The static page: a gallery of bundles, and each of them live in the browser."""
