"""How things look: colours, textures, glazes, prints."""
