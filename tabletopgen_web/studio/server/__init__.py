"""The HTTP side: who may ask, how much they may send, and which errors they get."""
