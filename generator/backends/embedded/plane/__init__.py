"""The table in a picture: its outline, its plane, and places on it."""
