"""Costs of calls: prices, budgets and the ledger."""
