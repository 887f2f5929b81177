# A realisation is a packing seed and a lug phase: golden section of the pitch of 30°.
PHASE_1 := 0
PHASE_2 := 18.541
PHASE_3 := 7.082
PHASE_4 := 25.623
PHASE_5 := 14.164
PHASE_6 := 2.705
PHASE_7 := 21.246
PHASE_8 := 9.787
PHASE_9 := 28.328
PHASE_10 := 16.869
PHASE_11 := 5.410
PHASE_12 := 23.951
