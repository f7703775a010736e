"""From a Function to a Program: statements, names, sections."""
