"""Parts of the speed and soak benchmarks."""
