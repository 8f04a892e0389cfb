"""Boards, electronic parts and components."""
