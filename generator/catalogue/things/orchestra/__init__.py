"""For the music room: strings, winds, drums and what belongs to them."""
