"""What calls cost: prices, budgets and what was spent."""
