"""Balls and gear of sports."""
