"""Things in vessels and racks: what room there is, and how each thing stands in its place."""
