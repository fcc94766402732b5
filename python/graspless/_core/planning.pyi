"""
Budget of a query, shared by all planners.
"""
from __future__ import annotations
import typing
__all__: list[str] = ['Budget', 'Field', 'OutOfTime', 'poll', 'set_deadline']
class Field:
    """
    Description of an option or of a counter.
    """
    def __repr__(self) -> str:
        ...
    @property
    def bounds(self) -> dict[str, typing.Any]:
        """
        Bounds of a number under the names gt, ge, lt and le.
        """
    @property
    def name(self) -> str:
        """
        Name of the attribute.
        """
    @property
    def range(self) -> str:
        """
        Interval of a number; may be empty.
        """
    @property
    def source(self) -> str:
        """
        Symbol, section or equation of the planner's paper; may be empty.
        """
    @property
    def text(self) -> str:
        """
        Description in one or two sentences.
        """
    @property
    def unit(self) -> str:
        """
        Unit, such as "m"; may be empty.
        """
class OutOfTime(BaseException):
    """
    Raised where a deadline ends work outside planners.
    """
class Budget:
    """
    Limits of a query in time and iterations, and its random seed.
    """
    @staticmethod
    def fields() -> list[Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 10.0, iterations: typing.SupportsInt | typing.SupportsIndex | None = None, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        seconds: wall clock [s], above 0, may be inf. iterations: rounds of the main loop, None for no limit. seed: of all random numbers, from 0 to 2^64 - 1.
        
        The same seed and iterations give the same plan, bit by bit, unless the clock ends the search first.
        """
    def __repr__(self) -> str:
        ...
    def part(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex, seed: typing.SupportsInt | typing.SupportsIndex, iterations: typing.SupportsInt | typing.SupportsIndex | None = None) -> Budget:
        """
        Returns a budget for one part of a longer query, with its own seconds and seed.
        
        iterations: None for those of this budget. stop() of either stops both.
        """
    def stop(self) -> None:
        """
        Stops the search that uses this budget, from any thread. The search returns within about 10 ms; a task that is being read is read first.
        
        A stopped budget stays stopped: later searches that use it end at once.
        """
    @property
    def is_stopped(self) -> bool:
        """
        True if stop() was called.
        """
    @property
    def iterations(self) -> int | None:
        """
        Iterations of the planner's main loop. Default: no limit.
        """
    @property
    def seconds(self) -> float:
        """
        Wall-clock time.
        
        Unit: s.
        """
    @property
    def seed(self) -> int:
        """
        Seed of all random numbers.
        """
def poll() -> None:
    """
    Raises OutOfTime if this thread's deadline has passed.
    """
def set_deadline(seconds: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
    """
    Makes work of this thread outside planners, such as reading a mesh, raise OutOfTime after so many seconds. None: no deadline.
    """
