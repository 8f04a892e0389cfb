"""What drinks are made and served with."""
