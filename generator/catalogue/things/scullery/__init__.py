"""Kitchen machines and hand tools for one job each."""
