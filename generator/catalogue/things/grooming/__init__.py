"""What one washes, shaves, combs and makes up with."""
