"""TabletopBench: fixed suites of held-out tables for the evaluation of policies.

===================  ===============================================================================
``suites``           the suites by name, and their files
``instances``        the contents of a suite: tables, their tasks and episodes
``training_tables``  training tables, separate from all listed tables
``tables``           a suite's tables on disk, regenerated bit for bit
``players``          the players: random, zero, the expert, policy files, functions
``run``              resumable runs; ``episode`` runs their episodes
``results``          result files with a digest
``comparison``       comparison of results; ``leaderboard`` the page of all results
``suite_drafts``     creation of suites
===================  ===============================================================================
"""
