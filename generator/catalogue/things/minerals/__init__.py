"""Out of the ground: cut gems, rough stones, ores, fossils."""
