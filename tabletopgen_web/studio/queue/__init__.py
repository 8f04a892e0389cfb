"""Jobs and events in a database, and the processes that run the jobs."""
