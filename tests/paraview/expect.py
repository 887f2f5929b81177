"""expect.py RESULTS.H5 OUT.NPZ: what a reader of the run has to find, by h5py."""
import sys

import h5py
import numpy

f = h5py.File(sys.argv[1])
numpy.savez(
    sys.argv[2],
    discs_points=f["discs/position_m"],
    wheel_points=f["wheel/position_m"],
    quads=f["wheel/quad"],
    part=f["wheel/part"],
    **{name: f["discs/" + name] for name in ("radius_m", "speed_m_s", "pressure_Pa", "id")},
)
