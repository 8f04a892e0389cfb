"""Clothes and what goes with them: underwear, hats, bags, laces, buckles."""
