"""Groups of options that commands share, one file each."""
