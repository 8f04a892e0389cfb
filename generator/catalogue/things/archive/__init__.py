"""Papers, certificates, coins and notes."""
