"""Objects of ``tabletop_objects`` on their own: checks, pictures, exports and a gallery page."""
