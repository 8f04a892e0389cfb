"""The things, a folder for each part of a home."""
