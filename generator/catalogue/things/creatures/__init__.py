"""Small animals, as models or alive: insects, snails, worms."""
