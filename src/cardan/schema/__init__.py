"""What the compiler and what runs share as data, each said once."""
