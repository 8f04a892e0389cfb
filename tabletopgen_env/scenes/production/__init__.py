"""Fresh tables, made in processes of their own."""
