"""From text to scene plan: objects, their attributes, and their relations."""
