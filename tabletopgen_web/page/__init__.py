"""The static page: a gallery of bundles, each with an interactive view in the browser."""
