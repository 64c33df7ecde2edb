"""The package as its users have it: python3 -m pytest tests/python. HASH: what tests/npm/scene.c prints."""
import math
import os
import pydoc
import pytest
import weft

numpy = pytest.importorskip('numpy')


def scene():
    world = weft.World(gravity=(0, -10))
    ground = world.body('static', shapes=[weft.box(12, 0.5)])
    for row in range(8):
        for k in range(row + 1):
            world.body(position=(k - row / 2, 8 - row), shapes=[weft.box(0.45, 0.45)])
    arm = world.body(position=(-7, 5), shapes=[weft.box(2, 0.25)])
    world.joint('revolute', ground, arm, anchor=(-7, 5), motorSpeed=2, motorForce=500)
    last = ground
    for k in range(10):
        ball = world.body(position=(6 + k / 2, 9), shapes=[weft.circle(0.25)])
        world.joint('revolute', last, ball, anchor=(5.75 + k / 2, 9))
        last = ball
    return world


def test_the_same_bits_as_in_c():
    world = scene()
    world.step(300)
    assert str(world.hash) == os.environ['HASH']


def test_a_fall():
    world = weft.World(gravity=(0, -10))
    ball = world.body(position=(0, 100), shapes=[weft.circle(0.5, density=2)])
    world.step(60)
    t = world.time
    assert abs(ball.position[1] - (100 - 5 * t * t)) <= 10 * t / 60 / 2 + 1e-3   # half a step, and rounding
    assert ball.mass == pytest.approx(2 * math.pi / 4, rel=1e-6)


def test_states_are_the_engines_own():
    world = scene()
    states = world.states
    assert states.shape == (len(world.bodies), 8) and not states.flags.owndata
    before = states.copy()
    world.step()
    assert (states != before).any()
    ball = world.bodies[-1]
    assert tuple(world.states[ball.index, :2]) == pytest.approx(ball.centre)
    with pytest.raises(ValueError):
        states[0, 0] = 1
    kept = weft.World().states                  # its world lives as long as the view
    assert kept.shape[1] == 8


def test_snapshots_and_files(tmp_path):
    world = scene()
    world.step(50)
    kept, at = world.snapshot(), world.hash
    world.step(20)
    then = world.hash
    world.restore(kept)
    assert world.hash == at
    world.save(tmp_path / 'a.weft')
    other = weft.World()
    other.load(tmp_path / 'a.weft')
    other.step(20)
    assert other.hash == then
    with pytest.raises(weft.WeftError) as e:
        other.load(tmp_path / 'nothing')
    assert e.value.code == 'WF_ERROR_FILE'


@pytest.mark.parametrize('wrong, code, word', [
    (lambda w: w.body(position=(math.nan, 0)), 'WF_ERROR_NOT_FINITE', 'position.x'),
    (lambda w: w.body(positon=(0, 0)), 'WF_ERROR_UNKNOWN', 'positon'),
    (lambda w: w.body(shapes=[weft.circle(1, friction=-1)]), 'WF_ERROR_RANGE', 'friction'),
    (lambda w: w.body('dynamical'), 'WF_ERROR_UNKNOWN', 'kinematic'),
    (lambda w: w.step(-1), 'WF_ERROR_RANGE', 'count'),
    (lambda w: weft.World(timeStep=0), 'WF_ERROR_RANGE', 'timeStep'),
    (lambda w: w.joint('revolut', w.bodies[0], w.bodies[1]), 'WF_ERROR_UNKNOWN', ''),
])
def test_what_is_refused_says_why(wrong, code, word):
    world = scene()
    at = world.hash
    with pytest.raises(weft.WeftError) as e:
        wrong(world)
    assert e.value.code == code and word in str(e.value) and world.hash == at


def test_bodies_shapes_joints():
    world = weft.World(gravity=(0, -10))
    wall = world.body('static')
    wheel = world.body(position=(3, 0), shapes=[weft.circle(0.5)])
    hinge = world.joint('revolute', wall, wheel, anchor=(3, 0), motorSpeed=2, motorForce=100)
    world.step(60)
    assert hinge.speed == pytest.approx(2, abs=1e-3)
    assert hinge.load[0][1] == pytest.approx(10 * wheel.mass, abs=1e-2)
    shape, = wheel.shapes
    shape.set(density=4)
    assert shape.body == wheel and wheel.mass == pytest.approx(math.pi, rel=1e-6)
    hit, fraction, point, normal = world.ray((3, 5), (0, -10))
    assert hit == shape and fraction == pytest.approx(0.45) and normal == pytest.approx((0, 1))
    hinge.remove()
    wheel.kick((wheel.mass, 0))
    assert wheel.velocity[0] == pytest.approx(1, abs=1e-4)
    wheel.remove()
    assert not wheel.valid and not shape.valid


def test_help_has_units():
    assert 'm/s' in pydoc.render_doc(weft.Body.velocity, renderer=pydoc.plaintext)
    assert 'gravity: acceleration of everything that has mass, m/s^2' in weft.World.__doc__
    assert 'N s' in weft.api.wfApplyImpulseToBody.__doc__ and 'kg/m^2' in weft.api.wfShapeDef.__doc__
    for thing in (weft.World, weft.Body, weft.Shape, weft.Joint):
        for name, part in vars(thing).items():
            assert name.startswith('_') or part.__doc__, f'{thing.__name__}.{name} has no help'
