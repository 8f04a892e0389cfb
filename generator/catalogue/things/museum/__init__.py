"""What museums and antique shops show: stones, vessels, arms, old machines."""
