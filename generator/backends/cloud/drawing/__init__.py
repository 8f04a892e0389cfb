"""Requests to image models, and processing of the pictures that they return."""
