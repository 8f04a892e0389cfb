"""What stands about to look at."""
