"""Equilibria, load paths and their stability."""
