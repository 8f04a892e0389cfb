"""A local web application to create, edit and view tables: ``tabletopgen studio``.

====================  ============================================================================
``contracts``         types of responses
``specs``, ``fields`` job requests and their validation
``folder``            the data folder
``queue/``            jobs and events in a database, and the processes that run the jobs
``worker``, ``work/`` the process of one job
``library/``          scenes, uploaded pictures, answers of studies
``server/``           access control, request limits, and error responses
``routes/``           the endpoints
``page_parts``        parts from the ``page`` package
``command``           the command
====================  ============================================================================

``docs/reference/studio-api.md`` lists the endpoints.
"""
