"""Outlines by a prompted model that the user fetches; table, camera and names stay the eye's."""
