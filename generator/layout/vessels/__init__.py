"""Objects in vessels and racks: the available room, and how each object stands in its place."""
