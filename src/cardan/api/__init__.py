"""What users hold: data of the rooms below, with every analysis as a method."""
