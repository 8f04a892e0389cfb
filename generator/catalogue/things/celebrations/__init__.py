"""Garlands, trimmings, party things, collectors' cards."""
