"""A text becomes a plan: what stands on the table, how it looks, and what stands where."""
