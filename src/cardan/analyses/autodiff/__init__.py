"""Functions of a model in programs that differentiate: JAX and PyTorch."""
