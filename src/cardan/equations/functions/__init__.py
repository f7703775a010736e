"""Functions of a system, each derived when it is requested."""
