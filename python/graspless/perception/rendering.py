# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth images of known scenes, with the faults of a depth camera."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import files
from .._core.perception import Body, Camera, cast_rays
from .arrays import packed

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import ArrayLike

    from ..frames import Matrix

Image = Any  # an array of one value per pixel

_BOUNDS = {
    "constant": (0, 0.1),
    "quadratic": (0, 0.1),
    "quantum": (0, 0.1),
    "jump": (1e-4, 10),
    "flying": (0, 1),
    "grazing": (0, math.pi / 2),
    "dark_patches": (0, 1000),
    "dark_radius": (0, 10),
}


@dataclass(frozen=True)
class Noise:
    """Faults of a depth camera.

    Attributes
    ----------
    constant : float
        Standard deviation of the depth at distance 0 [m].
    quadratic : float
        Its growth with the squared depth [1/m]: the deviation is constant + quadratic * z^2.
    quantum : float
        Step between the depths that the camera can express [m]. 0: none.
    jump : float
        Least difference of depth between neighbouring pixels that makes flying pixels [m].
    flying : float
        Fraction of the pixels beside a jump whose depth is a mixture of both sides.
    grazing : float
        Angle between ray and surface normal from which pixels begin to drop out [rad]. At a right
        angle all do.
    dark_patches : int
        Number of dark patches, at random places on what is seen.
    dark_radius : float
        Their radius [m]. In a patch, nine of ten pixels drop out.
    """

    constant: float = 0.001
    quadratic: float = 0.002
    quantum: float = 0.001
    jump: float = 0.01
    flying: float = 0.5
    grazing: float = math.radians(80)
    dark_patches: int = 2
    dark_radius: float = 0.012

    def __post_init__(self) -> None:
        """Raises ValueError that names the field, its value and its range."""
        for field in fields(self):
            value, (low, high) = getattr(self, field.name), _BOUNDS[field.name]
            if not low <= value <= high:
                raise ValueError(f"noise.{field.name} is {value}; it must lie in [{low}, {high:g}]")

    @staticmethod
    def none() -> Noise:
        """Returns the noise of a perfect camera."""
        return Noise(0, 0, 0, flying=0, grazing=math.pi / 2, dark_patches=0)


@dataclass(frozen=True, eq=False)
class Frame:
    """A depth image with its camera, and the truth about it. It equals only itself.

    Attributes
    ----------
    depth : array [H, W]
        Depths along the optical axis as the camera gives them [m], float32. 0: no measurement.
    K : array [3, 3]
        Camera matrix [pixels].
    X_WC : array [4, 4]
        Pose of the camera's optical frame in the world.
    labels : array [H, W]
        Index of the body that each ray meets first; -1: none.
    clean : array [H, W]
        Exact depths [m], float32. 0 if a ray meets nothing.
    """

    depth: Image
    K: Matrix
    X_WC: Matrix
    labels: Image
    clean: Image

    def __repr__(self) -> str:
        height, width = self.depth.shape
        return f"<Frame of {width} x {height} pixels>"

    def save(self, path: str | Path) -> None:
        """Writes the arrays depth, K, X_WC, labels and clean to an .npz file at `path`.

        Raises TaskError if the file cannot be written.
        """
        files.write(path, packed({field.name: getattr(self, field.name) for field in fields(self)}))


def look_at(eye: ArrayLike, target: ArrayLike) -> Matrix:
    """Returns the pose of a camera that looks at a point, with its lower edge level.

    Parameters
    ----------
    eye, target : array [3]
        Position of the camera, and the point that it looks at, in the world [m].

    Returns
    -------
    array [4, 4]
        X_WC of the optical frame: x right, y down, z forward.

    Raises
    ------
    ValueError
        The two points are equal.
    """
    begin, end = (np.asarray(point, dtype=float).reshape(3) for point in (eye, target))
    distance = float(np.linalg.norm(end - begin))
    if not 0 < distance < math.inf:
        raise ValueError(f"target {end} must be finite and differ from eye {begin}")
    forward = (end - begin) / distance
    right = np.cross(forward, [0.0, 0.0, 1.0])
    if np.linalg.norm(right) < 1e-9:  # straight up or down
        right = np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    X_WC = np.eye(4)
    X_WC[:3, :3] = np.column_stack([right, np.cross(forward, right), forward])
    X_WC[:3, 3] = begin
    return X_WC


def render(
    bodies: Sequence[Body],
    X_WC: ArrayLike,
    camera: Camera | None = None,
    noise: Noise | None = None,
    seed: int = 1,
) -> Frame:
    """Renders the depth image of a known scene as a camera would give it.

    Parameters
    ----------
    bodies : sequence of Body
        Boxes, convex hulls and meshes at poses in the world.
    X_WC : array [4, 4]
        Pose of the camera's optical frame C in the world: x right, y down, z forward.
    camera : Camera, optional
        By default 640 x 480 pixels with a horizontal field of view of 60 degrees.
    noise : Noise, optional
        Faults of the camera.
    seed : int, optional
        The same seed gives the same image. Several images of a still scene have seeds of their own.

    Returns
    -------
    Frame
        Depths, and the body that each ray met.

    Raises
    ------
    ValueError
        A bad pose, shape, or camera; names it.
    """
    camera = Camera() if camera is None else camera
    rays = cast_rays(list(bodies), np.asarray(X_WC, dtype=float), camera)
    clean = np.asarray(rays.depth)
    depth = _spoil(clean, rays.cosine, camera.K, noise or Noise(), np.random.default_rng(seed))
    return Frame(depth, camera.K, np.array(X_WC, dtype=float), np.asarray(rays.label), clean)


def _spoil(clean: Image, cosine: Image, K: Matrix, noise: Noise, rng: np.random.Generator) -> Image:
    """Returns the depths with all faults."""
    depth = clean.astype(float)
    is_hit = clean > 0
    depth = np.where(_is_drawn(noise.flying, rng, clean), _mixed(depth, noise.jump, rng), depth)
    depth += (noise.constant + noise.quadratic * depth**2) * rng.standard_normal(clean.shape)
    if noise.quantum > 0:
        depth = noise.quantum * np.round(depth / noise.quantum)
    lost = _is_grazing(cosine, noise.grazing, rng) | _is_dark(clean, K, noise, rng)
    return np.where(is_hit & ~lost & (depth > 0), depth, 0.0).astype(np.float32)


def _is_drawn(share: float, rng: np.random.Generator, image: Image) -> Image:
    return rng.random(image.shape) < share


def _mixed(depth: Image, jump: float, rng: np.random.Generator) -> Image:
    """Returns the depths in which pixels beside a jump are mixtures of both of its sides."""
    mixed, share = depth.copy(), rng.random(depth.shape)
    padded = np.pad(depth, 1, mode="edge")
    height, width = depth.shape
    for row, column in ((0, 1), (2, 1), (1, 0), (1, 2)):
        other = padded[row : row + height, column : column + width]
        # A plane seen at a grazing angle also has steps, of equal height on both sides.
        opposite = padded[2 - row : 2 - row + height, 2 - column : 2 - column + width]
        step, before = np.abs(other - depth), np.abs(opposite - depth)
        is_jump = (depth > 0) & (other > 0) & (step > jump + 2 * before)
        mixed = np.where(is_jump, share * depth + (1 - share) * other, mixed)
    return mixed


def _is_grazing(cosine: Image, grazing: float, rng: np.random.Generator) -> Image:
    """Draws the pixels that drop out: from none at the angle `grazing` to all at a right angle."""
    begin = math.cos(grazing)
    share = 1 - np.asarray(cosine) / begin if begin > 1e-9 else np.zeros(np.shape(cosine))
    return rng.random(share.shape) < share


def _is_dark(clean: Image, K: Matrix, noise: Noise, rng: np.random.Generator) -> Image:
    """Draws the pixels that drop out in patches, each a ball about a point that is seen."""
    lost = np.zeros(clean.shape, dtype=bool)
    hits = np.argwhere(clean > 0)
    if not len(hits) or not noise.dark_patches:
        return lost
    rows, columns = np.indices(clean.shape)
    rays = np.stack([(columns - K[0, 2]) / K[0, 0], (rows - K[1, 2]) / K[1, 1]], axis=-1)
    points = np.concatenate([rays, np.ones((*clean.shape, 1))], axis=-1) * clean[..., None]
    for _ in range(noise.dark_patches):
        center = points[tuple(hits[rng.integers(len(hits))])]
        lost |= np.linalg.norm(points - center, axis=-1) < noise.dark_radius
    return lost & (clean > 0) & (rng.random(clean.shape) < 0.9)
