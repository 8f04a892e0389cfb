"""What goes along on a journey."""
