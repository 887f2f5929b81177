# A realisation is a packing seed and a phase of the tyre's 56 columns: golden section of their pitch of 6.43°.
PHASE_1 := 0
PHASE_2 := 3.973
PHASE_3 := 1.518
PHASE_4 := 5.491
PHASE_5 := 3.035
PHASE_6 := 0.580
PHASE_7 := 4.553
PHASE_8 := 2.097
