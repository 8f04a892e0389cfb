"""Cheese, seafood, roasts and snacks from far and near."""
