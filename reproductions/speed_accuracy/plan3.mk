# Chapter 3: one change each from its whole scene, B3 under 170 N on Earth; `fitted` is the chapter's case.
CASE   := $(CHAPTER)/cases/whole.toml
SLIPS  := 60 20
FINEST := step0.5
# Packings and lug phases of these: REALISATIONS; of the others one.
SEVERAL := step0.5 whole fitted step1.5 step2 step2.25 step3 discs1.5 discs2 depth0.5 length0.75 speed0.2 elements0.5 discs2_step3 lean
SINGLE  := step4 step6 rigid elastic coarse fine euler1 speed0.05
# Runs beyond these. The text's own step is one that the chapter makes (FIDELITY=dissertation).
MORE := step0.25-s60-r1

set_step0.25   := $(call step_set,1e-5)
set_step0.5    := $(call step_set,2e-5)
set_step1.5    := $(call step_set,6e-5)
set_step2      := $(call step_set,8e-5)
set_step2.25   := $(call step_set,9e-5)
# Beyond limits that are certain: a sunk bed as it stands (near 1e-4 s), then the wheel's elements (1.5e-4 s), then an isolated pair of
# discs (2.1e-4 s). Run all the same, to show the end.
set_step3      := $(call step_set,1.2e-4) --allow-unstable
set_step4      := $(call step_set,1.6e-4) --allow-unstable
set_step6      := $(call step_set,2.4e-4) --allow-unstable
# What `ifedem fit` left (reports/speed_accuracy/fit/chapter3.toml): the chapter's own case.
case_fitted    := $(CHAPTER)/cases/B3-earth.toml
set_euler1     := --set integrator=modified-euler-one
set_rigid      := --set wheel.body=rigid
set_elastic    := --set wheel.body=elastic $(call step_set,1.5e-5)
set_coarse     := --set wheel.intermediate_rings=2 --set wheel.surface_rings=1
set_fine       := --set wheel.intermediate_rings=8 --set wheel.surface_rings=4
set_speed0.05  := --set travel.speed_m_s=0.05
set_speed0.2   := --set travel.speed_m_s=0.2
# The soil of a radius r times as large has 1/r² of the discs; half the depth has half of them.
set_discs1.5   := $(call radii_set,0.003,0.00375,0.0045) --set bed.disc_count=8652
set_discs2     := $(call radii_set,0.004,0.005,0.006) --set bed.disc_count=4867
set_depth0.5   := --set bed.disc_count=9734
# Half the bed's height as elements under the discs, with the elastic constants of this sand (chapter 2: 0.71 MPa and 0.04) and the
# density of its bulk.
soil_elements = --set elements.columns=$(1) --set elements.rows=1 --set elements.block_height_m=$(2) \
                --set elements.material.young_Pa=0.71e6 --set elements.material.poisson=0.04 --set contact.friction_elements=0.6
set_elements0.5 := $(call soil_elements,10,0.135) --set bed.disc_count=9734
# Three quarters of the bin end 0.275 m beyond a travel of 0.5 m; the window is the same share of it.
set_length0.75 := --set bed.length_m=1.125 --set bed.disc_count=14601 --set travel.distance_m=0.5
# The savings together. Discs twice as large bear twice the step, as far as the wheel's elements do.
set_discs2_step3 := $(set_discs2) $(call step_set,1.2e-4)
set_lean       := $(call radii_set,0.003,0.00375,0.0045) --set bed.length_m=1.125 --set bed.disc_count=6489 \
                  --set travel.distance_m=0.5 $(call step_set,8e-5)

# How much dearer a disc-step is; 0 where the end comes soon.
TIMES_step4 := 0
TIMES_step6 := 0
TIMES_euler1 := 1.2
TIMES_fine := 1.5
TIMES_elements0.5 := 1.1

# The bed of these is that of the whole scene.
WHOLE_BED := whole rigid coarse fine speed0.05 speed0.2

ifdef QUICK
CASE    := $(HERE)/cases/short3.toml
SEVERAL := step0.5 whole step2 step4 depth0.75 elements0.5
SINGLE  :=
MORE    :=
set_depth0.75 := --set bed.disc_count=1800
set_elements0.5 := $(call soil_elements,4,0.045) --set bed.disc_count=1200
endif
