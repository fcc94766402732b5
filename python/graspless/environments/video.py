# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of an episode: rendered by MuJoCo, and written as a video."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import TaskError, explain, missing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

KEY = "observation.images.front"
HEIGHT, WIDTH = 192, 256  # [pixels]
CODEC, PIXELS = "libsvtav1", "yuv420p"  # those of lerobot
_OPTIONS = {"g": "2", "crf": "30", "preset": "11"}  # any frame can be read alone
_ROBOT, _OBJECT, _FIXED = (0.6, 0.65, 0.7, 1.0), (0.95, 0.5, 0.1, 1.0), (0.75, 0.68, 0.58, 1.0)
_LOOK, _DISTANCE, _AZIMUTH, _ELEVATION = (0.6, 0.0, 0.15), 1.7, 140.0, -25.0  # [m, deg]


class Painter:
    """Renders a simulation, without a GPU if MUJOCO_GL is egl or osmesa.

    Parameters
    ----------
    model : mujoco.MjModel
    """

    def __init__(self, model: Any) -> None:
        import mujoco

        self._camera = mujoco.MjvCamera()
        self._camera.lookat = _LOOK
        self._camera.distance = _DISTANCE
        self._camera.azimuth, self._camera.elevation = _AZIMUTH, _ELEVATION
        _paint(model)
        try:
            self._renderer = mujoco.Renderer(model, HEIGHT, WIDTH)
        except Exception as error:  # of OpenGL's libraries
            raise TaskError(
                f"render: MuJoCo cannot render here ({explain(error)}): MUJOCO_GL is "
                f"'{os.environ.get('MUJOCO_GL', '')}', should be egl or osmesa without a screen"
            ) from None
        for effect in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            self._renderer.scene.flags[effect] = 0  # slow without a GPU

    def paint(self, data: Any) -> NDArray[np.uint8]:
        """Returns a picture [H, W, 3] of the present state."""
        self._renderer.update_scene(data, self._camera)
        picture: NDArray[np.uint8] = self._renderer.render()
        return picture

    def close(self) -> None:
        """Frees the context of OpenGL."""
        self._renderer.close()


def _paint(model: Any) -> None:
    """Gives robot, object and surroundings colours, and more light; motions stay the same."""
    model.vis.headlight.ambient[:], model.vis.headlight.diffuse[:] = 0.45, 0.55
    model.vis.quality.offsamples = 0
    for geom in range(model.ngeom):
        root = model.body_rootid[model.geom_bodyid[geom]]
        is_free = model.body_dofnum[root] == 6
        is_fixed = model.body_weldid[model.geom_bodyid[geom]] == 0
        model.geom_rgba[geom] = _OBJECT if is_free else _FIXED if is_fixed else _ROBOT


def encoder() -> Any:
    """Returns PyAV. Raises TaskError that names its extra if it is not installed."""
    try:
        import av
    except ImportError as error:
        raise missing(error, "video") from None
    return av


def write(path: Path, pictures: Sequence[NDArray[np.uint8]], rate: int) -> None:
    """Writes pictures [H, W, 3] as an MP4."""
    av = encoder()
    os.environ.setdefault("SVT_LOG", "1")  # the encoder tells of errors alone
    with av.open(str(path), "w") as container:
        stream = container.add_stream(CODEC, rate=rate, options=_OPTIONS)
        stream.height, stream.width = pictures[0].shape[:2]
        stream.pix_fmt = PIXELS
        for picture in pictures:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, "rgb24")))
        container.mux(stream.encode())


def histogram(pictures: Sequence[NDArray[np.uint8]]) -> NDArray[np.int64]:
    """Returns how often each value occurs in each channel [3, 256], over all pictures."""
    found = np.zeros((3, 256), dtype=np.int64)
    for picture in pictures:
        for channel in range(3):
            found[channel] += np.bincount(picture[..., channel].ravel(), minlength=256)
    return found
