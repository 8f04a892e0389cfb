"""Certificates of the tasks that the expert solves on a bundle's table."""
