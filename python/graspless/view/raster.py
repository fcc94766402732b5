# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders triangles with hidden surfaces, shadows and outlines, in plain numpy.

matplotlib's own 3-D axes sort whole triangles by distance, which draws an arm that reaches around a
table wrongly. A depth buffer takes forty lines and no graphics card.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from ..frames import Matrix
    from .bodies import Body

SHADOW_SIZE = 700  # pixels along a side of the shadow map
GLASS = 0.15  # opacity
BEHIND = 1e-3  # what is nearer, or behind the eye, is drawn at this distance [m]
BLOCK, CHUNK = 12, 1000  # side of small triangles [pixels], and how many are drawn at once


@dataclass
class Camera:
    """A perspective camera.

    Attributes
    ----------
    eye, target : array [3]
        In the world [m].
    angle : float
        Field of view, from top to bottom [rad].
    """

    eye: Matrix
    target: Matrix
    angle: float = 0.6

    def axes(self) -> Matrix:
        """Returns the directions right, up and forward, [3, 3] in the world."""
        forward = (self.target - self.eye) / np.linalg.norm(self.target - self.eye)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        return np.stack([right, np.cross(right, forward), forward])

    def light(self) -> Matrix:
        """Returns the direction to the light, over the viewer's left shoulder, [3]."""
        right, _, forward = self.axes()
        toward = np.array([0.0, 0.0, 1.0]) - 0.4 * right - 0.55 * forward
        return np.asarray(toward / np.linalg.norm(toward))

    def fitted(self, points: Matrix, width: int, height: int, margin: float = 0.04) -> Camera:
        """Returns a camera at the same position, turned and zoomed to fit points [N, 3]."""
        camera = self
        for _ in range(4):  # each turn changes the perspective a little
            right, up, forward = camera.axes()
            screen = camera.project(points, width, height)
            low, high = screen[:, :2].min(axis=0), screen[:, :2].max(axis=0)
            focal = height / 2 / np.tan(camera.angle / 2)
            off = ((low + high) / 2 - [width / 2, height / 2]) / focal
            reach = float(np.linalg.norm(camera.target - camera.eye))
            target = camera.eye + reach * (forward + off[0] * right - off[1] * up)
            fill = ((high - low) / [width, height]).max() / (1 - 2 * margin)
            angle = 2 * np.arctan(np.tan(camera.angle / 2) * fill)
            camera = Camera(camera.eye, target, float(angle))
        return camera

    def project(self, points: ArrayLike, width: int, height: int) -> Matrix:
        """Returns pixel x, pixel y and 1 / distance, [N, 3], of points in the world, [N, 3]."""
        seen = (np.asarray(points) - self.eye) @ self.axes().T
        near = 1.0 / np.maximum(seen[:, 2], BEHIND)
        focal = height / 2 / np.tan(self.angle / 2)
        x = width / 2 + focal * seen[:, 0] * near
        y = height / 2 - focal * seen[:, 1] * near
        return np.column_stack([x, y, near])


def render(
    placed: Sequence[tuple[Body, Matrix]], camera: Camera, width: int, height: int
) -> Matrix:
    """Renders bodies at their poses.

    Parameters
    ----------
    placed : sequence of (Body, array [4, 4])
        Each body with its pose in the world.
    camera : Camera
    width, height : int
        Size of the picture [pixels]; it is rendered at twice that and averaged.

    Returns
    -------
    array [height, width, 4]
        Red, green, blue and opacity, 0 to 1.
    """
    scene = _gather(placed)
    w, h = 2 * width, 2 * height
    screen = camera.project(scene["points"], w, h)
    faces = scene["faces"]
    toward = np.einsum("ij,ij->i", scene["normals"], camera.eye - scene["points"][faces[:, 0]])
    is_ahead = (screen[faces, 2] < 1 / BEHIND).any(axis=1)
    _, face = _depth_buffer(screen, faces, np.flatnonzero((toward > 0) & is_ahead), w, h)
    rgba = np.zeros((h, w, 4))
    ys, xs = np.nonzero(face >= 0)
    if len(xs):
        f = face[ys, xs]
        weights = _weights(screen[faces[f]], xs + 0.5, ys + 0.5)
        points = np.einsum("nk,nkj->nj", weights, scene["points"][faces[f]])
        normals = np.einsum("nk,nkj->nj", weights, scene["corners"][f])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        away = np.einsum("ij,ij->i", normals, camera.eye - points) < 0
        normals[away & scene["two_sided"][f]] *= -1
        light = np.clip(normals @ camera.light(), 0, 1) * _lit(
            scene, points, normals, camera.light()
        )
        sky = 0.5 + 0.5 * normals[:, 2]
        brightness = 0.46 + 0.18 * sky + 0.42 * light
        rgba[ys, xs, :3] = scene["colors"][f] * brightness[:, None]
        rgba[ys, xs, 3] = 1
        rgba[_outlines(np.where(face >= 0, scene["bodies"][face], -1)), :3] *= 0.45
    pixels = rgba.reshape(height, 2, width, 2, 4)
    pixels[..., :3] *= pixels[..., 3:]
    mean: Matrix = pixels.mean(axis=(1, 3))
    mean[..., :3] /= np.maximum(mean[..., 3:], 1e-6)
    return np.clip(mean, 0, 1)


def render_past(
    obstacles: Sequence[tuple[Body, Matrix]],
    placed: Sequence[tuple[Body, Matrix]],
    p_W: Matrix,
    camera: Camera,
    width: int,
    height: int,
) -> Matrix:
    """Renders bodies and obstacles; obstacles between the viewer and a point [3] are of glass."""
    hiding = [_hides(one, p_W, camera) for one in obstacles]
    clear = [one for one, hides in zip(obstacles, hiding, strict=True) if not hides]
    picture = render([*placed, *clear], camera, width, height)
    if not any(hiding):
        return picture
    return over(render([*placed, *obstacles], camera, width, height), picture, GLASS)


def over(front: Matrix, back: Matrix, share: float) -> Matrix:
    """Returns a picture with another in front of it, at `share` of that one's opacity."""
    weight = share * front[..., 3:]
    opacity = weight + (1 - weight) * back[..., 3:]
    color = weight * front[..., :3] + (1 - weight) * back[..., 3:] * back[..., :3]
    return np.concatenate([color / np.maximum(opacity, 1e-6), opacity], axis=2)


def _hides(placed: tuple[Body, Matrix], p_W: Matrix, camera: Camera) -> bool:
    """Returns True if a body is between the viewer and a point [3]."""
    body, X_WB = placed
    corners = [frames.transform(X_WB, part.vertices)[part.triangles] for part in body.parts]
    screen = camera.project(np.concatenate(corners).reshape(-1, 3), 1, 1).reshape(-1, 3, 3)
    point = np.broadcast_to(camera.project([p_W], 1, 1), (len(screen), 3))
    with np.errstate(divide="ignore", invalid="ignore"):  # triangles that are seen edge on
        weights = _weights(screen, point[:, 0], point[:, 1])
        near: Matrix = 1 / (weights / screen[:, :, 2]).sum(axis=1)
    is_ahead = (screen[:, :, 2] < 1 / BEHIND).all(axis=1)
    return bool((is_ahead & (weights >= 0).all(axis=1) & (near > point[:, 2])).any())


def _gather(placed: Sequence[tuple[Body, Matrix]]) -> dict[str, Any]:
    """Collects all triangles in the world, with normals at faces and corners."""
    points, faces, colors, owners, given = [], [], [], [], []
    count = 0
    for index, (body, X_WB) in enumerate(placed):
        for part in body.parts:
            points.append(frames.transform(X_WB, part.vertices))
            faces.append(part.triangles + count)
            colors.append(np.tile(part.color, (len(part.triangles), 1)))
            owners.append(np.full(len(part.triangles), index))
            count += len(part.vertices)
            own = np.zeros_like(part.vertices) if part.normals is None else part.normals
            given.append(own @ X_WB[:3, :3].T)
    p, f = np.concatenate(points), np.concatenate(faces)
    areas = np.cross(p[f[:, 1]] - p[f[:, 0]], p[f[:, 2]] - p[f[:, 0]])
    normals = areas / np.maximum(np.linalg.norm(areas, axis=1, keepdims=True), 1e-15)
    smooth = np.zeros_like(p)
    for k in range(3):
        np.add.at(smooth, f[:, k], areas)
    smooth /= np.maximum(np.linalg.norm(smooth, axis=1, keepdims=True), 1e-15)
    shading = np.concatenate(given)
    has_own = np.any(shading != 0, axis=1, keepdims=True)[:, 0]
    corners = np.where(has_own[:, None], shading, smooth)[f]
    return {
        "points": p,
        "faces": f,
        "normals": normals,
        "corners": corners,
        "colors": np.concatenate(colors),
        "bodies": np.concatenate(owners),
        "two_sided": has_own[f[:, 0]],
    }


def _depth_buffer(
    screen: Matrix, faces: NDArray[np.int64], visible: NDArray[np.int64], w: int, h: int
) -> tuple[Matrix, NDArray[np.int64]]:
    """Returns depth and nearest triangle of each pixel; depth grows towards the viewer."""
    near = np.full((h, w), -np.inf)
    face = np.full((h, w), -1, dtype=np.int64)
    corners = screen[faces]
    low = np.clip(np.floor(corners[:, :, :2].min(axis=1)), 0, [w, h]).astype(int)
    high = np.clip(np.ceil(corners[:, :, :2].max(axis=1)), 0, [w, h]).astype(int)
    wide = high - low
    seen = visible[(wide[visible] > 0).all(axis=1)]
    small = wide[seen].max(axis=1) <= BLOCK
    _draw_small(near, face, corners, low, seen[small])
    for index in seen[~small]:
        (x0, y0), (x1, y1) = low[index], high[index]
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners[index].tolist()
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if abs(area) < 1e-9:
            continue
        x = np.arange(x0, x1) + 0.5
        y = (np.arange(y0, y1) + 0.5)[:, None]
        u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
        v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
        t = 1 - u - v
        z = u * az + v * bz + t * cz
        window = near[y0:y1, x0:x1]
        better = (u >= 0) & (v >= 0) & (t >= 0) & (z > window)
        window[better] = z[better]
        face[y0:y1, x0:x1][better] = index
    return near, face


def _draw_small(
    near: Matrix,
    face: NDArray[np.int64],
    corners: Matrix,
    low: NDArray[np.int64],
    chosen: NDArray[np.int64],
) -> None:
    """Draws triangles of at most BLOCK pixels per side, many at once for speed."""
    h, w = near.shape
    step = np.arange(BLOCK)
    for start in range(0, len(chosen), CHUNK):
        some = chosen[start : start + CHUNK]
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = np.moveaxis(
            corners[some][..., None, None], (1, 2), (0, 1)
        )
        column = low[some, 0][:, None, None] + step
        row = low[some, 1][:, None, None] + step[:, None]
        x, y = column + 0.5, row + 0.5
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        area = np.where(np.abs(area) < 1e-9, np.inf, area)
        u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
        v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
        t = 1 - u - v
        inside = (u >= 0) & (v >= 0) & (t >= 0) & (column < w) & (row < h) & np.isfinite(area)
        owner, j, i = np.nonzero(inside)
        pixel = row[owner, j, 0] * w + column[owner, 0, i]
        z = (u * az + v * bz + t * cz)[inside]
        order = np.lexsort((-owner, z, pixel))
        pixel, z, owner = pixel[order], z[order], owner[order]
        last = np.append(pixel[1:] != pixel[:-1], True) if len(pixel) else np.empty(0, dtype=bool)
        pixel, z, owner = pixel[last], z[last], owner[last]
        better = z > near.ravel()[pixel]
        near.ravel()[pixel[better]] = z[better]
        face.ravel()[pixel[better]] = some[owner[better]]


def _weights(corners: Matrix, x: Any, y: Any) -> Matrix:
    """Returns barycentric weights, [N, 3], of pixels in their triangles, [N, 3, 3]."""
    (ax, ay), (bx, by), (cx, cy) = (corners[:, k, :2].T for k in range(3))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
    v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
    weights = np.stack([u, v, 1 - u - v], axis=1) * corners[:, :, 2]
    return np.asarray(weights / weights.sum(axis=1, keepdims=True))


def _lit(scene: dict[str, Any], points: Matrix, normals: Matrix, toward: Matrix) -> Matrix:
    """Returns 1 for points in the light and less for points in a shadow, with soft borders."""
    across = np.cross(toward, [0.0, 1.0, 0.0])
    across /= np.linalg.norm(across)
    axes = np.stack([across, np.cross(toward, across), toward])
    flat = scene["points"] @ axes.T
    low, size = flat.min(axis=0), np.ptp(flat, axis=0)[:2].max() + 1e-9
    scale = (SHADOW_SIZE - 4) / size

    def place(p: Matrix) -> Matrix:
        return np.column_stack([(p[:, :2] - low[:2]) * scale + 2, p[:, 2]])

    faces = scene["faces"]
    away = np.flatnonzero(scene["normals"] @ toward > 0)
    near, _ = _depth_buffer(place(flat), faces, away, SHADOW_SIZE, SHADOW_SIZE)
    # Slightly off the surface: otherwise faces in grazing light shade themselves in stripes.
    at = place((points + 2 / scale * normals) @ axes.T)
    lit = np.zeros(len(points))
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            x = np.clip(at[:, 0].astype(int) + dx, 0, SHADOW_SIZE - 1)
            y = np.clip(at[:, 1].astype(int) + dy, 0, SHADOW_SIZE - 1)
            lit += near[y, x] <= at[:, 2] + 2.5 / scale
    return lit / 9


def _outlines(owner: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Returns the pixels at which a body borders on another body or on the background."""
    edge = np.zeros(owner.shape, dtype=bool)
    edge[:, 1:] |= owner[:, 1:] != owner[:, :-1]
    edge[1:] |= owner[1:] != owner[:-1]
    return edge & (owner >= 0)
