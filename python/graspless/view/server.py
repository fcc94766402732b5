# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""viser server that only this machine can reach."""

from __future__ import annotations

import contextlib
import io
import socket
from functools import partial
from typing import TYPE_CHECKING, Any

from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .scene import Layers


@contextlib.contextmanager
def open_server(port: int) -> Iterator[Any]:
    """Starts a viser server that only this machine can reach."""
    import viser

    check_port(port)
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # suppresses viser's banner
            server = viser.ViserServer(host="127.0.0.1", port=port, verbose=False)
    except OSError as error:
        raise TaskError(f"--port: {port}: cannot be served: {error.strerror}") from None
    try:
        yield server
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()


def check_port(port: int) -> None:
    """Raises TaskError unless the port is free.

    viser waits for ever for a port that it may not use, and takes the next one if it is busy.
    """
    if not 1 <= port <= 65535:
        raise TaskError(f"--port: {port}: should be from 1 to 65535")
    try:
        with socket.socket() as probe:
            # Like servers do, so that a port counts as free as soon as its last server has ended.
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind(("127.0.0.1", port))
    except OSError as error:
        raise TaskError(f"--port: {port}: cannot be served: {error.strerror}") from None


def free_port() -> int:
    """Returns a port that nothing uses now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def add_boxes(server: Any, layers: Layers) -> None:
    """Adds a check box for each layer, which hides and shows it."""
    with server.gui.add_folder("layers"):
        for name, handle in layers.handles.items():
            box = server.gui.add_checkbox(name, initial_value=handle.visible)
            box.on_update(partial(_follow, box, handle))


def _follow(box: Any, handle: Any, _: Any) -> None:
    handle.visible = box.value
