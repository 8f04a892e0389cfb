"""What one sews, knits and weaves with, and cloths."""
