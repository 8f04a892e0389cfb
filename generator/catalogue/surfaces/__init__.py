"""Appearance: colours, textures, glazes, prints."""
