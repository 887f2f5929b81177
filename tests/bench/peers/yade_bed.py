# The bed of lammps.in in YADE. From the environment: LAW (none, spring), DATA (CSV bed), SKIN, W, GX, GMAG, WARM, STEPS.
import math, os, time

env = os.environ
law = env['LAW']
kn, kt, cn, friction, wall_friction, rolling_friction = 1e5, 2.5e4, 2500 * 2.17e-3, math.atan(0.6), math.atan(0.4), 0.1
length, g_mag, g_x = float(env['W']), float(env['GMAG']), float(env['GX'])
bed = [tuple(map(float, line.split(','))) for line in open(env['DATA']) if line[0] not in '#x']


def material(label, r, angle):
    if law == 'spring':  # stiffness k_n at the radius; no dashpot in this law
        return CohFrictMat(young=kn / r, poisson=kt / kn, frictionAngle=angle, density=2600, isCohesive=False, normalCohesion=0,
                           shearCohesion=0, momentRotationLaw=True, alphaKr=0.25, etaRoll=0.5 * rolling_friction, alphaKtw=0, label=label)
    # Springs and dashpots of two bodies stand in series. The dashpot is one constant: that of the mean pair's m_eff.
    return ViscElMat(kn=2 * kn, ks=2 * kt, cn=2 * cn, cs=0, mR=0, mRtype=1, frictionAngle=angle, density=2600, label=label)


def wall_material():
    if law == 'spring': return FrictMat(young=kn / 0.0025, poisson=kt / kn, frictionAngle=wall_friction, density=2600, label='wall')
    return material('wall', 0.0025, wall_friction)


for r in sorted({disc[2] for disc in bed}): O.materials.append(material('r%g' % r, r, friction))
O.materials.append(wall_material())
for x, y, r, *motion in bed:
    body = utils.sphere((x, y, 0), r, material='r%g' % r)
    body.state.mass = 260 * math.pi * r * r
    inertia = 0.5 * body.state.mass * r * r
    body.state.inertia = (inertia, inertia, inertia)
    body.state.blockedDOFs = 'zXY'
    if motion: body.state.vel, body.state.angVel = (motion[0], motion[1], 0), (0, 0, motion[2])
    O.bodies.append(body)
walls = [O.bodies.append(utils.wall(at, axis=axis, sense=sense, material='wall')) for at, axis, sense in ((0, 0, 1), (length, 0, -1), (0, 1, 1))]

collider = InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=float(env['SKIN']))
if law == 'spring':
    loop = InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(), Ig2_Wall_Sphere_ScGeom()],
                           [Ip2_FrictMat_FrictMat_FrictPhys(),
                            Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=False, setCohesionOnNewContacts=False)],
                           [Law2_ScGeom_FrictPhys_CundallStrack(),
                            Law2_ScGeom6D_CohFrictPhys_CohesionMoment(useIncrementalForm=True, always_use_moment_law=True)])
else:
    loop = InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                           [Law2_ScGeom_ViscElPhys_Basic()])
s = g_mag / math.hypot(g_x, 1)
# Numerical damping stands in for the dashpot that the cohesive law lacks. YADE's usual 0.2 would slow the avalanche by a fifth.
damping = 0.015 if law == 'spring' else 0
O.engines = [ForceResetter(), collider, loop, NewtonIntegrator(damping=damping, gravity=(g_x * s, -s, 0), dampGravity=False)]
O.dt = 1e-5

O.run(int(env['WARM']), True)
cpu = time.process_time()
O.run(int(env['STEPS']), True)
cpu = time.process_time() - cpu

discs = [O.bodies[k].state for k in range(len(bed))]
mass = sum(d.mass for d in discs)
contacts = O.interactions.countReal() - sum(1 for w in walls for i in O.bodies[w].intrs() if i.isReal)
print('RESULT', cpu, 2 * contacts / len(bed), sum(d.mass * d.pos[1] for d in discs) / mass, sum(d.mass * d.vel[0] for d in discs) / mass,
      sum(0.5 * d.mass * (d.vel[0]**2 + d.vel[1]**2) for d in discs), flush=True)
