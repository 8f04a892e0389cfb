"""Jobs and events in a database, and the processes that do the jobs."""
