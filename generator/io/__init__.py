"""Bounded readers of untrusted input, atomic writers, and safe terminal output."""
