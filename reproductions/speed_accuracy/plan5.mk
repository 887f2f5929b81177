# Chapter 5: the tyre at 40 % over discs only, the whole scene, and over the text's regions; changes of the small region, and savings of
# discs only.
CASE   := $(CHAPTER)/cases/discs.toml
SLIPS  := 40
FINEST := step0.5
SEVERAL := step0.5 whole row large middle small adaptive small_step0.5 small_step1.5 small_discs1.5 small_discs2 small_handover step1.5 discs2
SINGLE  := discs1.5 depth0.5 length0.8 rigid step2 small_step2 small_rigid small_fine small_speed2
MORE    :=

case_small  := $(CHAPTER)/cases/small.toml
case_middle := $(CHAPTER)/cases/middle.toml
case_large  := $(CHAPTER)/cases/large.toml
case_row    := $(CHAPTER)/cases/row.toml
set_step0.5    := $(call step_set,2e-5)
# The lattice of the smallest discs bears 6.1e-5 s; at 8e-5 s the bed does not come to rest.
set_step1.5    := $(call step_set,6e-5)
set_step2      := $(call step_set,8e-5) --allow-unstable
set_discs1.5   := $(call radii_set,0.003,0.00375,0.0045) --set bed.disc_count=20569
set_discs2     := $(call radii_set,0.004,0.005,0.006) --set bed.disc_count=11570
set_depth0.5   := --set bed.disc_count=23140
# The bin ends 0.395 m beyond the way.
set_length0.8  := --set bed.length_m=1.92 --set bed.disc_count=37024
set_rigid      := --set wheel.body=rigid
# Three blocks to begin with hold the tyre's contact, 0.2 m; the text's five hold its whole width.
case_adaptive := $(case_small)
set_adaptive  := --set elements.region=adaptive --set elements.first_disc_column=4 --set elements.disc_columns=3
set_small_step0.5  := $(call step_set,2e-5)
set_small_step1.5  := $(call step_set,6e-5)
set_small_step2    := $(call step_set,8e-5) --allow-unstable
set_small_discs1.5 := $(call radii_set,0.003,0.00375,0.0045) --set elements.pattern_discs=636
set_small_discs2   := $(call radii_set,0.004,0.005,0.006) --set elements.pattern_discs=358
set_small_handover := --set elements.stress_handover=mean
set_small_rigid    := --set wheel.body=rigid
set_small_fine     := --set wheel.smooth_columns=56 --set wheel.intermediate_rings=4 --set wheel.surface_rings=2
set_small_speed2   := --set travel.speed_m_s=0.1952

# Elements, conversions and patterns beside the discs: measured at 40 %, chapter 5's README.
TIMES_small := 1.1
TIMES_step2 := 0
TIMES_small_step2 := 0
WHOLE_BED := whole rigid

ifdef QUICK
CASE    := $(CHAPTER)/cases/short.toml
SEVERAL := step0.5 whole
SINGLE  := step2 handover
set_handover := --set elements.stress_handover=mean
endif
