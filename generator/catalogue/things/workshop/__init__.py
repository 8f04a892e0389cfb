"""What workshops and electronics benches hold besides the usual tools."""
