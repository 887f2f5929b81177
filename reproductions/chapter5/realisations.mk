# A realisation is a packing seed (bed.seed): of the bin's discs, and of the discs of a block.
