"""Tools for single objects of ``tabletop_objects``: checks, pictures, exports, a gallery page."""
