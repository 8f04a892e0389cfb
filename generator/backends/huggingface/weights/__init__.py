"""Pinned models: location, download and loading."""
