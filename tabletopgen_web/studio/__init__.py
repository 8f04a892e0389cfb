"""A local web application to make, change and look at tables: ``tabletopgen studio``.

====================  ============================================================================
``contracts``         what requests and answers hold
``specs``, ``fields`` jobs, as a page asks for them
``folder``            where everything is kept
``queue/``            jobs and events in a database, and the processes that do the jobs
``worker``, ``work/`` the process of one job
``library/``          scenes, uploaded pictures, answers of studies
``server/``           who may ask, how much they may send, which errors they get
``routes/``           the endpoints
``page_parts``        what it takes from the pages' package
``command``           the command
====================  ============================================================================

``docs/reference/studio-api.md`` lists the endpoints.
"""
