"""Pictures of plans, of hidden parts, and of the table from above."""
