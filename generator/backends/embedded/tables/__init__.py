"""The table as a solid, fitted to its picture."""
