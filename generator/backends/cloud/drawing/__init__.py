"""Requests to image models and the processing of their pictures."""
