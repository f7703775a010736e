"""Gradients of motions: sensitivities and adjoints of what a run has computed."""
