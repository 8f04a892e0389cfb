"""A single model that fits many scenes, and each scene as a row of its varying fields."""
