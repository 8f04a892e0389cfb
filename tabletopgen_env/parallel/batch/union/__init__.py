"""One model that any of many scenes fits into, and a scene as one row of what differs in it."""
