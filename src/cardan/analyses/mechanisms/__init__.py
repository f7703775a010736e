"""Closed loops: assembly, sweeps, singular positions, redundancy."""
