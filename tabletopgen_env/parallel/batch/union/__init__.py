"""A single model that fits many scenes, with a row of varying fields for each scene."""
