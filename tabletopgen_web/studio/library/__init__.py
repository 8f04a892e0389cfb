"""What the studio keeps besides jobs: scenes, uploaded pictures, answers of studies."""
