"""Games, toys, books and maps."""
