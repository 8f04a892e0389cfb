"""The scripted expert: where to put the fingers, and how to move an object."""
