# As slip.gp, against the slip that the travel had.
slip_label = "slip by Eq 3.8, measured [%]"
least_slip = -8
load "reproductions/chapter3/slip.gp"
