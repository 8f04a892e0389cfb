"""Coffee gear, small morsels by the piece, and things for a fire."""
