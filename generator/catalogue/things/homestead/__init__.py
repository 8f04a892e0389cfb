"""What is fixed to a house, cleans it, or stands in its garden."""
