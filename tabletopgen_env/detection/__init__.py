"""Learned grasp detection in height maps like those of a depth camera above the table."""

from __future__ import annotations
