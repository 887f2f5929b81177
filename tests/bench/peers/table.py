#!/usr/bin/env python3
"""Tables of run_peers.sh's runs.csv: table.py alike RUNS (status 1 if the beds differ), table.py cost RUNS SUMMARY."""
import csv
import statistics
import sys

LIMITS = {'mean_height_m': 0.01, 'mean_vx_m_s': 0.05, 'kinetic_J': 0.05}  # relative, from LAMMPS with the same law
with open(sys.argv[2]) as file:
    runs = list(csv.DictReader(file))
rolls = lambda law: law != 'none'
order = lambda run: (run['state'], rolls(run['law']), run['code'] != 'ifedem', run['code'], run['law'])


def groups(keys):
    found = {}
    for run in sorted(runs, key=order): found.setdefault(tuple(run[k] for k in keys), []).append(run)
    return found


def check_alike():
    """At rest only the height is judged: what else there is, 0.1 mm/s, is the end of the settling."""
    alike = True
    print(f'\n{"state":8} {"law":8} {"code":9} {"height mm":>16} {"mean vx mm/s":>18} {"kinetic energy J":>20} {"contacts":>9}')
    for (state, law, code), (run, *_) in groups(('state', 'law', 'code')).items():
        reference = next((r for r in runs if (r['code'], r['state'], r['law']) == ('lammps', state, law)), None)
        cells, verdict = [], '' if reference else 'a law of its own'
        for name, scale in (('mean_height_m', 1e3), ('mean_vx_m_s', 1e3), ('kinetic_J', 1)):
            cell = f'{float(run[name]) * scale:.5g}'
            if reference and (state == 'flow' or name == 'mean_height_m'):
                off = float(run[name]) / float(reference[name]) - 1
                cell += f' ({100 * off:+.2f} %)'
                if abs(off) > LIMITS[name]: alike, verdict = False, 'DIFFERS'
            cells.append(cell)
        print(f'{state:8} {law:8} {code:9} {cells[0]:>16} {cells[1]:>18} {cells[2]:>20} {float(run["contacts_a_disc"]):9.2f} {verdict}')
    return 0 if alike else 1


def print_cost():
    cost = {key: [float(r['ns_particle_step']) for r in group] for key, group in groups(('state', 'law', 'code')).items()}
    ours = {(state, law): statistics.median(ns) for (state, law, code), ns in cost.items() if code == 'ifedem'}
    fastest, summary = {}, []
    print(f'\nCPU ns a particle-step, one core\n{"state":8} {"law":8} {"code":9} {"n":>2} {"min":>7} {"median":>7} {"max":>7}  median / ifedem\'s')
    for (state, law, code), ns in cost.items():
        middle, ratios = statistics.median(ns), []
        for (our_state, our_law), our_ns in ours.items():
            if code == 'ifedem' or our_state != state or rolls(our_law) != rolls(law): continue
            ratios.append(f'{middle / our_ns:.1f} ({our_law})')
            summary.append((f'ratio_{code}_{law}_to_{our_law}_{state}', middle / our_ns))
            if law == our_law or (our_law == 'rolling' and (state, law) not in ours):  # the same law, or the nearest there is
                name = 'ratio_rolling' if rolls(law) else 'ratio_no_rolling'
                fastest[name] = min(fastest.get(name, 1e9), middle / our_ns)
        print(f'{state:8} {law:8} {code:9} {len(ns):2} {min(ns):7.1f} {middle:7.1f} {max(ns):7.1f}  {", ".join(ratios)}')
    with open(sys.argv[3], 'w') as file:
        file.write('name,value,unit\n' + ''.join(f'{name},{value:.3g},1\n' for name, value in [*fastest.items(), *summary]))
    for name, value in fastest.items(): print(f'{name}: the fastest peer takes {value:.1f} times as long, in the state where it does best')


sys.exit(check_alike() if sys.argv[1] == 'alike' else print_cost())
