"""compare.py RUN EXPECTED.NPZ, by pvbatch: each frame as ParaView reads it against expect.py's."""
import sys

import numpy
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

run, expected = sys.argv[1], numpy.load(sys.argv[2])
faults = []


def compare(where, name, found, wanted):
    if found is None or found.shape != wanted.shape or not numpy.array_equal(found, wanted):
        faults.append(f"{where}: {name} differs")


def array_of(data, name):
    array = data.GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def look(reader, part, where):
    frames = expected[part + "_points"]
    times = list(reader.TimestepValues)
    if len(times) != len(frames):
        faults.append(f"{where}: {len(times)} frames instead of {len(frames)}")
        return
    for k, time in enumerate(times):
        reader.UpdatePipeline(time)
        data = servermanager.Fetch(reader)
        if data.IsA("vtkMultiBlockDataSet"):
            data = data.GetBlock(0)
        points = vtk_to_numpy(data.GetPoints().GetData())
        compare(where, f"frame {k}, points", points[:, :2], frames[k])
        if part == "discs":
            for name in ("radius_m", "speed_m_s", "pressure_Pa", "id"):
                compare(where, f"frame {k}, {name}", array_of(data.GetPointData(), name), expected[name][k])
            cells = numpy.arange(len(points))[:, None]  # a vertex each, so that something is drawn
        else:
            compare(where, f"frame {k}, part", array_of(data.GetCellData(), "part"), expected["part"])
            cells = expected["quads"]
        corners = [[data.GetCell(c).GetPointId(i) for i in range(data.GetCell(c).GetNumberOfPoints())]
                   for c in range(data.GetNumberOfCells())]
        compare(where, f"frame {k}, cells", numpy.array(corners), cells)


version = simple.GetParaViewVersion()
for part in ("discs", "wheel"):
    # The two Xdmf3 readers of ParaView 5.11 know no HyperSlab and crash.
    look(simple.XDMFReader(FileNames=[f"{run}/{part}.xdmf"]), part, f"{part}.xdmf")
    frames, points = expected[part + "_points"].shape[:2]
    print(f"ParaView {version.major}.{version.minor}, {part}.xdmf: {frames} frames, {points} points")
print("\n".join(faults) or "fine")
sys.exit(1 if faults else 0)
