"""For measuring and showing nature: instruments, models, laboratory machines."""
