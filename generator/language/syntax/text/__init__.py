"""From text to words and tokens, and the function words of English."""
