"""Exports in their target physics engines."""
