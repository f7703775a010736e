"""Records of runs: states over time, events, energy, files."""
