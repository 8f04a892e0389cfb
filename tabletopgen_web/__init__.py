"""Web pages for tables: a static gallery, a local studio, and user studies.

The front end is TypeScript in ``web/``, which ``make web`` builds into ``static/``.
"""
