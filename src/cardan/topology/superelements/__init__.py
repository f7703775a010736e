"""Superelements as bodies, joints and what they are made of."""
