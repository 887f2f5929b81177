#!/usr/bin/env python3
"""One timed run, printed as a CSV line: one_run.py CODE LAW STATE REPEAT. run_peers.sh sets directory and environment."""
import csv
import math
import os
import resource
import statistics
import subprocess
import sys

code, law, state, repeat = sys.argv[1:]
steps, warm = int(os.environ['STEPS']), int(os.environ['WARM'])
bed = 'flow20k' if state == 'flow' else 'bed20k'
tilt = 0.7 if state == 'flow' else 0.0
log = f'{code}-{law}-{state}.log'
# From earlier trials of each code on these beds.
skin_m = {'lammps': '2e-4', 'liggghts': '3e-4', 'yade': '2e-4', 'ifedem': ''}[code]
scene = {'W': '2.0', 'skin': skin_m, 'gmag': f'{9.81 * math.hypot(tilt, 1):.10g}', 'gx': f'{tilt:g}', 'warm': str(warm), 'steps': str(steps)}


def read_bed():
    with open(bed + '.csv') as file:
        return [[float(v) for v in line.split(',')] for line in file if line[0] not in '#x']


discs = read_bed()


def write_data(path):
    """LAMMPS takes a sphere's density, LIGGGHTS (in 2D) a disc's: both such that the mass is 260 π r² kg."""
    with open(path, 'w') as f:
        f.write(f'discs\n\n{len(discs)} atoms\n{2 if code == "liggghts" else 1} atom types\n\n-0.01 2.01 xlo xhi\n'
                f'-0.01 {max(d[1] for d in discs) + 0.1:.4f} ylo yhi\n-0.05 0.05 zlo zhi\n\nAtoms\n\n')
        for n, (x, y, r, *_) in enumerate(discs, 1):
            f.write(f'{n} 1 {2 * r:.10g} {260 if code == "liggghts" else 195 / r:.12g} {x:.12g} {y:.12g} 0\n')
        if len(discs[0]) > 3:
            f.write('\nVelocities\n\n')
            for n, (*_, vx, vy, omega) in enumerate(discs, 1):
                f.write(f'{n} {vx:.12g} {vy:.12g} 0 0 0 {omega:.12g}\n')


def run(command, **environment):
    """On one core, one thread."""
    done = subprocess.run(['taskset', '-c', os.environ['CPU']] + command, env=dict(os.environ, OMP_NUM_THREADS='1', **environment),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode: sys.exit(f'{" ".join(command)} failed:\n{done.stdout[-2000:]}')
    return done.stdout


def run_lammps_or_liggghts():
    """CPU seconds, contacts a disc, mean height, mean speed along x, kinetic energy."""
    data = f'{bed}.{code}'
    if not os.path.exists(data): write_data(data)
    values = dict(scene, data=data, **({'law': law} if code == 'lammps' else {'rolling': {'none': 'off', 'spring': 'epsd2'}[law]}))
    program = ['lmp', '-nocite'] if code == 'lammps' else ['liggghts']
    if os.path.exists('ticks'): os.remove('ticks')
    run(program + ['-log', log, '-screen', 'none', '-in', code + '.in'] + [word for k, v in values.items() for word in ('-v', k, v)])
    begin, end = (int(line) for line in open('ticks'))
    with open(log) as file:
        lines = file.read().split('\n')
    row = [line for n, line in enumerate(lines[1:]) if 'KinEng' in lines[n]][-1]
    return [(end - begin) / os.sysconf('SC_CLK_TCK')] + [float(v) for v in row.split()[1:]]


def run_yade():
    out = run(['yade', '-x', '-n', '-j1', 'yade_bed.py'], LAW=law, DATA=bed + '.csv', **{k.upper(): v for k, v in scene.items()})
    return [float(v) for v in next(line for line in out.split('\n') if line.startswith('RESULT')).split()[1:]]


def run_ifedem():
    """The median of five sections: one is over in a tenth of a second, the others' take a second in which slow moments of the machine even out."""
    table = log.replace('.log', '.csv')
    rows = []
    for _ in range(5):
        if os.path.exists(table): os.remove(table)
        run([os.environ['STEP_BENCH'], '--bed', bed + '.csv', '--flow' if tilt else '--settled', '--as-peers', '--law', law,
             '--warm', str(warm), '--steps', str(steps), '--blocks', '1', '--csv', table])
        with open(table) as file:
            rows.append(next(csv.DictReader(file)))
    ns = statistics.median(float(row['cpu_ns_particle_step']) for row in rows)
    return [ns * 1e-9 * len(discs) * steps] + [float(rows[-1][k]) for k in ('contacts_a_disc', 'mean_height_m', 'mean_vx_m_s', 'kinetic_J')]


cpu_s, *motion = {'lammps': run_lammps_or_liggghts, 'liggghts': run_lammps_or_liggghts, 'yade': run_yade, 'ifedem': run_ifedem}[code]()
peak_MB = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(','.join([code, law, state, repeat, str(steps), f'{cpu_s:.4f}', f'{cpu_s / steps / len(discs) * 1e9:.2f}'] +
               [f'{v:.7g}' for v in motion] + [f'{peak_MB:.0f}']))
