# Chapter 4: one change each from its whole scene, the tyre under 980 N. Contact stress as well; the semi-empirical wheel beside it.
CASE   := $(CHAPTER)/cases/tyre.toml
SLIPS  := 22 55
FINEST := step0.5
SEVERAL := step0.5 whole step1.25 discs2 discs2_step2 lean
SINGLE  := step2 step3 discs1.5 depth0.5 length0.85 elements0.5
# At 22 % alone: a step, a speed, wheels, and smaller steps if the chapter has made them (`step` of its chapter.mk).
MORE := step1.5-s22-r1 speed2-s22-r1 rigid-s22-r1 coarse-s22-r1 fine-s22-r1 $(foreach p,0.25:dt1e5 0.125:dt5e6,$(if $(wildcard \
        $(FINISHED)/chapter4/$(lastword $(subst :, ,$(p)))-tyre-s22-r1/run.csv),step$(firstword $(subst :, ,$(p)))-s22-r1))
# Plates on the same bed (chapter.mk), N on 0.15 × 0.17 m.
PLATES := plate-127.5N plate-255N plate-510N plate-1020N
PLATE_CASE := $(CHAPTER)/cases/plate.toml

set_step0.125  := $(call step_set,5e-6)
set_step0.25   := $(call step_set,1e-5)
set_step0.5    := $(call step_set,2e-5)
set_step1.25   := $(call step_set,5e-5)
# Beyond the limit of the smallest discs in a triangular lattice, 4.9e-5 s: what the sunk bed still bears, then a bed that does not come
# to rest, then one that blows up.
set_step1.5    := $(call step_set,6e-5) --allow-unstable
set_step2      := $(call step_set,8e-5) --allow-unstable
set_step3      := $(call step_set,1.2e-4) --allow-unstable
levelled = --set bed.disc_count=$(1) --set bed.levelled_count=$(2)
set_discs1.5   := $(call radii_set,0.0024,0.003,0.0036) $(call levelled,13815,13614)
set_discs2     := $(call radii_set,0.0032,0.004,0.0048) $(call levelled,7771,7658)
set_depth0.5   := $(call levelled,15542,15315)
# The bin ends 0.33 m beyond the way, a wheel's radius and 6 cm.
set_length0.85 := --set bed.length_m=1.53 $(call levelled,26421,26036)
# The lower half of the bed's height, 0.23 m, as elements with chapter 5's constants.
set_elements0.5 := --set elements.columns=12 --set elements.rows=1 --set elements.block_height_m=0.115 --set contact.friction_elements=0.6 \
                  $(call levelled,15542,15315)
set_rigid      := --set wheel.body=rigid
set_coarse     := --set wheel.smooth_columns=28 --set wheel.intermediate_rings=2 --set wheel.surface_rings=1
set_fine       := --set wheel.smooth_columns=112 --set wheel.intermediate_rings=8 --set wheel.surface_rings=4
set_speed2     := --set travel.speed_m_s=0.1952
set_discs2_step2 := $(set_discs2) $(call step_set,8e-5)
set_lean       := $(call radii_set,0.0024,0.003,0.0036) --set bed.length_m=1.53 $(call levelled,11743,11572) $(call step_set,6e-5)

TIMES_step2 := 0
TIMES_step3 := 0
TIMES_fine := 1.5
TIMES_elements0.5 := 1.1
WHOLE_BED := whole rigid coarse fine speed2

ifdef QUICK
CASE    := $(CHAPTER)/cases/short.toml
SLIPS   := 22
SEVERAL := step0.5 whole
SINGLE  := step2
MORE    :=
PLATES  :=
endif
