"""TabletopBench: fixed suites of held-out tables, and what policies come to there.

==================  ===============================================================================
``suites``          the suites by name, and their files
``instances``       what a suite holds: tables, what is to be done there, episodes
``training_tables`` tables to train at, apart from all that are listed
``tables``          a suite's tables on disk, made again bit for bit
``players``         who plays: random, zero, the expert, policy files, functions
``run``             a run, which resumes; ``episode`` its episodes
``results``         files of results, with a digest
``comparison``      results side by side; ``leaderboard`` the page of all
``suite_drafts``    how suites were made
==================  ===============================================================================
"""
