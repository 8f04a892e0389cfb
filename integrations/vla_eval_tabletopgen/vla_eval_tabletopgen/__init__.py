"""TabletopGen's environments as a benchmark of vla-eval."""
