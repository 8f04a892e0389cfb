"""Pinned models: where they lie, downloading and loading them."""
