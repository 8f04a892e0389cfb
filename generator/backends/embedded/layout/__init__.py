"""What stands on what, where and how it is turned, as measured or guessed."""
