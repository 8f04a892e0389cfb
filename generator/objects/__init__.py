"""Tools for the objects of ``tabletop_objects``: checks, pictures, exports and a gallery page."""
