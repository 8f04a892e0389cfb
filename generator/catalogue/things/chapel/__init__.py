"""Of worship: holy books, altar things, statues, lamps, beads."""
