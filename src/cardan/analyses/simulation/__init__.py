"""Simulation: starts, methods, runs, events, records of runs."""
