include reproductions/chapter3/realisations.mk
