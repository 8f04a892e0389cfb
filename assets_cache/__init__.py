"""The store of scene bundles: starter bundles shipped here, and a user cache."""
