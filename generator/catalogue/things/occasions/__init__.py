"""Weddings, Easter, picnics and the bar: signs, cards, favours, hampers, spouts."""
