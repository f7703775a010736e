"""Linear models, modes, root loci, Campbell diagrams, trim."""
