"""Pages to see, make and judge tables: a static gallery, a local studio, a user study.

Their front end is TypeScript in ``web/``, which ``make web`` builds into ``static/``.
"""
