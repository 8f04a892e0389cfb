"""Tools, tableware and machines of a kitchen beyond the everyday ones."""
