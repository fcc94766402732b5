# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Entry point of the commands `graspless` and `python -m graspless`."""

import _signal  # type: ignore[import-not-found]  # the module `signal` takes time to import, in which a signal may come
import os
import sys

TYPE_CHECKING = False  # that of `typing` takes time too
if TYPE_CHECKING:
    from types import FrameType

# A command keeps one core busy, so threads for linear algebra only cost time. Looking for plugins
# of pydantic in every installed package takes longer than a plan.
DEFAULTS = {"OPENBLAS_NUM_THREADS": "1", "PYDANTIC_DISABLE_PLUGINS": "__all__"}


def main() -> int:
    """Runs one command; returns its exit code."""
    signals = _Signals()
    for name, value in DEFAULTS.items():
        os.environ.setdefault(name, value)
    import threading

    from . import cli
    from ._commands import BAD_INPUT, INTERRUPTED

    prepare()
    try:
        signals.is_running = True
        code = cli.main()
        signals.is_running = False
    except BaseException:
        signals.is_running = False
        if signals.came:
            signals.leave()
        raise
    if signals.came and code in (INTERRUPTED, BAD_INPUT):  # a library may turn it into an error
        code = 128 + signals.came
    if threading.active_count() == 1:
        _leave(code)
    return code


def prepare() -> None:
    """Sets up a process that runs one command and ends."""
    import gc

    from . import _commands

    gc.set_threshold(100_000)  # imports make many objects and hardly any garbage
    if sys.stdout is not None:  # names may have letters that the terminal lacks, or be any bytes
        sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    _commands.ends_with_command = True


class _Signals:
    """Answers SIGINT and SIGTERM by KeyboardInterrupt, so that a command cleans up.

    Before and after the command, and while it imports, the process ends at once: there is nothing
    to clean up but folders of `files.beside`, and modules that are half imported answer
    KeyboardInterrupt by errors of their own.
    """

    def __init__(self) -> None:
        self.came = 0
        self.is_running = False
        for number, default in (
            (_signal.SIGINT, _signal.default_int_handler),
            (_signal.SIGTERM, _signal.SIG_DFL),
        ):
            if _signal.getsignal(number) == default:  # neither ignored nor answered already
                _signal.signal(number, self._answer)

    def _answer(self, number: int, frame: "FrameType | None") -> None:
        self.came = self.came or number
        if not self.is_running or (_is_importing(frame) and not _has_threads()):
            self.leave()
        if number == _signal.SIGTERM:
            # `timeout` sends it twice; the second would stop the clean-up.
            _signal.signal(number, _signal.SIG_IGN)
        raise KeyboardInterrupt

    def leave(self) -> None:
        """Ends the process at once."""
        try:  # noqa: SIM105, contextlib takes time to import
            os.write(2, b"interrupted\n")
        except OSError:
            pass
        remove = getattr(sys.modules.get("graspless.files"), "remove_places", None)
        if remove is not None:
            remove()
        os._exit(128 + self.came)


def _is_importing(frame: "FrameType | None") -> bool:
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _has_threads() -> bool:
    threading = sys.modules.get("threading")
    return threading is not None and threading.active_count() > 1


def _leave(code: int) -> None:
    """Ends the process at once: taking a thousand modules apart takes as long as a plan."""
    import atexit

    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()
    os._exit(code)


if __name__ == "__main__":
    sys.exit(main())
