"""What pets and households need."""
