"""Faults drawn by a seed, put into functions of many scenes, and who finds them."""
