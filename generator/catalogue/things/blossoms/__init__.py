"""Garden and meadow flowers by the stem, sprigs, petals."""
