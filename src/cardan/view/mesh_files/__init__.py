"""Readers of mesh files, one per format. Files are untrusted."""
