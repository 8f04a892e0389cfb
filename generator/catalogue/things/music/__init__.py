"""Instruments, and what belongs to music."""
