"""Data shared by compiler and runtime, each in one place."""
