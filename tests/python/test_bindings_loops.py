# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loops, linking and sampling from Python: shapes of arrays, and what is wrong is named."""

import json

import numpy as np
import pytest

from graspless import clasp, geometry
from graspless.geometry import (
    Box,
    Capsule,
    ClaspTarget,
    Filtration,
    LoopOptions,
    LoopStatus,
    PlacedShape,
    PreparedLoop,
    Sphere,
    sample_surface,
    shortest_loops,
)


def ring(radius=0.1, tube=0.012, spacing=0.01):
    """Points on a ring about z, jittered."""
    rows = round(2 * np.pi * tube / spacing)
    points = []
    for v in 2 * np.pi * np.arange(rows) / rows:
        r = radius + tube * np.cos(v)
        u = np.linspace(0, 2 * np.pi, round(2 * np.pi * r / spacing), endpoint=False) + v / 8
        points.append(np.stack([r * np.cos(u), r * np.sin(u), 0 * u + tube * np.sin(v)], axis=1))
    cloud = np.vstack(points)
    return cloud + np.random.default_rng(1).normal(0, 0.0005, cloud.shape)


THROUGH = np.array([[0, 0, -1], [0, 0, 1], [1, 0, 1], [1, 0, -1]], dtype=float)
RING = ring()


def test_loops_of_a_cloud_in_one_line():
    (loop,) = shortest_loops(RING).found
    assert loop.points.shape == (len(loop.vertices), 3)
    np.testing.assert_array_equal(RING[loop.vertices], loop.points)
    closed = np.vstack([loop.points, loop.points[:1]])
    assert loop.length == pytest.approx(np.linalg.norm(np.diff(closed, axis=0), axis=1).sum())
    assert 2 * np.pi * 0.085 < loop.length < 2 * np.pi * 0.1
    assert loop.birth < 0.03 < 0.1 < loop.death
    assert 0.01 < loop.thickness < 0.03
    assert abs(geometry.linking_number(loop, THROUGH)) == 1


def test_loops_tell_what_they_were_taken_from():
    found = shortest_loops(RING.tolist())
    assert found.status is LoopStatus.found
    assert "1 loop at max_edge_length" in found.reason
    assert found.reason in repr(found)
    assert found.plateau.lower < found.complex.max_edge_length < found.plateau.upper
    assert found.plateau.ratio == pytest.approx(found.plateau.upper / found.plateau.lower)
    assert found.uncertain == []
    assert all("thick handle" in loop.reason for loop in found.meridians)
    assert found.noise > 0
    assert found.found[0].openness > 0.3
    assert found.found[0].jump < 1.5
    assert found.warnings == []
    assert len(found.betti.loops) == len(found.betti.max_edge_length)
    json.dumps([found.betti.loops, found.betti.max_edge_length, found.found[0].vertices])
    edges = found.complex.points[found.complex.edges]
    assert np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1).max() < found.complex.max_edge_length
    assert found.complex.triangles.shape[1] == 3


def test_options_are_keywords_or_an_object():
    given = shortest_loops(RING, 0.05)
    assert given.complex.max_edge_length == 0.05
    assert given.plateau.loops == 0
    same = shortest_loops(RING, options=LoopOptions(max_edge_length=0.05))
    np.testing.assert_array_equal(same.found[0].points, given.found[0].points)
    positional = shortest_loops(RING, LoopOptions(max_edge_length=0.05))
    assert positional.found[0].vertices == given.found[0].vertices
    options = LoopOptions()
    for name in ("min_ratio", "max_points", "polish", "threads"):
        assert f"{name}: " in shortest_loops.__doc__
        assert f"{name}={getattr(options, name)!r}" in repr(options)


def test_threads_change_no_loop():
    cloud = sample_surface(clasp.sample_object("lawn_mower"), 30000)
    one, *others = (
        shortest_loops(cloud, polish=True, threads=threads).found for threads in (1, 2, 4)
    )
    assert one[0].length < shortest_loops(cloud).found[0].length
    for other in others:
        assert [loop.vertices for loop in other] == [loop.vertices for loop in one]
        assert [loop.length for loop in other] == [loop.length for loop in one]


def test_no_hole_is_a_status():
    found = shortest_loops(sample_surface([PlacedShape(Sphere(0.1))], 400))
    assert found.status is LoopStatus.no_reliable_hole
    assert found.found == []
    assert found.reason == "every loop is a gap between points"  # the status says the rest
    assert len(found.betti.loops) > 0
    closed = shortest_loops(RING, 0.5)
    assert "too large" in closed.reason


def test_what_looks_wrong_is_warned_of():
    assert any("millimetres" in warning for warning in shortest_loops(1000 * RING).warnings)
    twice = shortest_loops(np.vstack([RING, RING[:7]]))
    assert twice.warnings == ["7 points equal others; equal points count once"]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: shortest_loops(RING[:, :2]), r"points has shape .* must have shape \(N, 3\)"),
        (lambda: shortest_loops(np.empty((0, 3))), "points"),
        (lambda: shortest_loops(RING[:15]), "20 distinct points, not 15"),
        (lambda: shortest_loops(np.where(RING[4] == RING, np.nan, RING)), "nan nan nan"),
        (lambda: shortest_loops(RING * [1, 1, 0]), "lie in a plane"),
        (lambda: shortest_loops(RING, -1), "max_edge_length must be in"),
        (lambda: shortest_loops(RING, min_ratio=0.5), "min_ratio must be greater than 1"),
        (lambda: shortest_loops(RING, threads=0), r"threads must be in \[1, 256\], not 0"),
        (lambda: shortest_loops(RING, max_points=1), "max_points must be in"),
        (lambda: geometry.clasp_targets(RING, 0), r"count must lie in \[1, 1000000\]"),
        (lambda: geometry.clasp_targets([[0, 0, 0]] * 3, 2), "loop must have"),
        (lambda: geometry.linking_number(THROUGH, [[0, 0, 1]]), "b must have at least 3 corners"),
        (lambda: Filtration(RING).span([0, 1, 300], 0.5 * 0.01), "no edge shorter"),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_filtration_is_every_complex_at_once():
    filtration = Filtration(RING, what="cloud")
    assert filtration.num_vertices == len(RING)
    widest = filtration.plateaus()[0]
    assert widest.loops == 1
    births, deaths = filtration.persistence().T
    assert (births < deaths).all()
    assert (np.diff(deaths / births) <= 1e-12).all()
    curve = filtration.betti()
    for d in (0.012, 0.02, 0.05):
        alive = int(((births < d) & (d <= deaths)).sum())
        step = np.searchsorted(curve.max_edge_length, d) - 1
        assert curve.loops[step] == alive
    loop = shortest_loops(RING).found[0]
    assert filtration.span(loop.vertices, 0.05) == (loop.birth, loop.death)
    small = filtration.complex(0.012)
    assert len(small.edges) < len(filtration.complex(0.03).edges)
    assert repr(small).startswith("<Complex of ")


def test_clasp_targets_lie_on_the_loop():
    loop = shortest_loops(RING).found[0]
    targets = geometry.clasp_targets(loop, 12)
    assert len(targets) == 12
    np.testing.assert_allclose(targets[0].point, loop.points[0])
    for target in targets:
        assert np.hypot(*target.point[:2]) == pytest.approx(0.09, abs=0.01)
        assert np.linalg.norm(target.tangent) == pytest.approx(1)
        assert abs(target.tangent @ target.point) < 0.03
    mine = ClaspTarget(point=[1, 2, 3], tangent=[0, 0, 1])
    np.testing.assert_array_equal(mine.point, [1, 2, 3])


def test_linking_of_curves():
    angle = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    circle = 0.5 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    number = geometry.linking_number(circle, THROUGH)
    assert abs(number) == 1
    assert geometry.gauss_linking(circle, THROUGH) == pytest.approx(number)
    assert geometry.linking_number(circle, THROUGH + [5, 0, 0]) == 0
    # An open curve is closed by its chord, of length 1 here.
    assert geometry.virtual_linking(circle, THROUGH) == pytest.approx(number * 5 / 6)
    opened = geometry.gauss_linking(circle, THROUGH, b_is_closed=False)
    assert 0.2 < abs(opened) < 1
    slope = geometry.virtual_linking_gradient(circle, THROUGH)
    assert slope.gradient.shape == THROUGH.shape
    assert slope.value == pytest.approx(number * 5 / 6)
    assert slope.linking_number == number
    prepared = PreparedLoop(circle)
    assert prepared.linking_numbers([THROUGH, THROUGH + [5, 0, 0]]) == [number, 0]
    np.testing.assert_allclose(prepared.gauss_linking([THROUGH]), [number], atol=1e-12)
    with pytest.raises(ValueError, match=r"curves\[1\]"):
        prepared.linking_numbers([THROUGH, [[0, 0]]])


def test_clouds_of_known_bodies():
    shapes = [PlacedShape(Box([0.2, 0.2, 0.2])), PlacedShape(Capsule(0.02, 0.5))]
    cloud = geometry.sample_surface(shapes, 500, seed=3)
    assert cloud.shape == (500, 3)
    np.testing.assert_array_equal(cloud, geometry.sample_surface(shapes, 500, seed=3))
    inside = (np.abs(cloud) < 0.0999).all(axis=1)
    assert not inside.any()
    seen = geometry.visible_points(cloud, [0, 5, 0])
    assert 100 < len(seen) < 400
    assert cloud[seen, 1].min() > -0.09
    step = geometry.spacing(cloud)
    assert 0.01 < step < 0.05
    kept = geometry.downsample(cloud, 3 * step)
    assert len(kept) < 250
    assert (np.diff(kept) > 0).all()


def open_box(count, seed):
    """Independent random points on the inner and outer faces of a box without a lid."""
    rng = np.random.default_rng(seed)
    faces = []  # area, corner and two sides
    for x, y, low in ((0.15, 0.1, 0.0), (0.147, 0.097, 0.005)):
        wide, deep, high = [2 * x, 0, 0], [0, 2 * y, 0], [0, 0, 0.15 - low]
        corners = [(-x, -y), (-x, -y), (x, -y), (-x, y)]
        for (a, b), side in zip(corners, (wide, deep, deep, wide), strict=True):
            faces.append(([a, b, low], side, high))
        faces.append(([-x, -y, low], wide, deep))
    corner, one, other = np.array(faces, dtype=float).transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(one, other), axis=1)
    k = rng.choice(len(faces), count, p=areas / areas.sum())
    u, v = rng.random((2, count, 1))
    return corner[k] + u * one[k] + v * other[k]


@pytest.mark.parametrize("count", [1000, 3000, 5000])
def test_hardly_any_gaps_between_random_points_are_holes(count):
    holes = 0
    for seed in range(8):  # 16, 59 and 77 holes if all points are used
        found = shortest_loops(open_box(count, seed))
        holes += len(found.found)
        assert any("random distances" in warning for warning in found.warnings)
    assert holes <= 1


def test_all_points_of_an_even_cloud_are_used():
    given = shortest_loops(open_box(3000, 0), LoopOptions(max_edge_length=0.02))
    assert not any("random" in text for text in given.warnings)
    assert len(shortest_loops(RING).found) == 1
    assert not any("random" in text for text in shortest_loops(RING).warnings)
