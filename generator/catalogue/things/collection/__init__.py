"""What people collect and decorate with: figures, models, curios, toys, fantasy."""
