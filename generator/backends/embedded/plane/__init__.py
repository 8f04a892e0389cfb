"""The table in a picture: its outline, its plane, and positions on it."""
