"""The system graph as text and as a picture."""
