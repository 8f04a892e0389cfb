"""Demonstrations by the expert: recording, cloning and replay buffers."""
