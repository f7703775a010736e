"""Fits of parameters and starts to measured motions."""
