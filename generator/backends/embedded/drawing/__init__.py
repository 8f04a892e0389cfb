"""Pictures of a plan, of hidden parts and of the table from above."""
