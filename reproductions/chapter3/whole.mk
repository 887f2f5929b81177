# The whole scene (cases/whole.toml) of any case of this chapter: what `ifedem fit` took away is there again.
WHOLE := --set time_step_s=4e-5 --set bed.length_m=1.5 --set bed.disc_count=19468 --set wheel.intermediate_rings=4
