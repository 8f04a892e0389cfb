"""Decoration and household."""
