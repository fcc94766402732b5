"""
What every planner shares: the budget of a query.
"""
from __future__ import annotations
import typing
__all__: list[str] = ['Budget']
class Budget:
    """
    Limits of a query in time and iterations, and its random seed.
    """
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 10.0, iterations: typing.SupportsInt | typing.SupportsIndex | None = None, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        seconds: wall-clock limit [s], may be inf. iterations: limit on rounds of the main loop, None for no limit. seed: of all random numbers.
        
        The same seed and iterations give the same plan, bit by bit, unless time runs out first.
        
        Raises ValueError unless seconds is positive and iterations is not negative.
        """
    def __repr__(self) -> str:
        ...
    def part(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex, seed: typing.SupportsInt | typing.SupportsIndex) -> Budget:
        """
        Returns a budget for one part of a longer query, with its own seconds and seed.
        
        stop() of either stops both.
        """
    def stop(self) -> None:
        """
        Stops the query that uses this budget, from any thread. The query returns within about 10 ms.
        
        A stopped budget stays stopped: later queries that use it end at once.
        """
    @property
    def is_stopped(self) -> bool:
        """
        True if stop() was called.
        """
    @property
    def iterations(self) -> int | None:
        """
        Limit on rounds of the main loop; None for no limit.
        """
    @property
    def seconds(self) -> float:
        """
        Wall-clock limit [s].
        """
    @property
    def seed(self) -> int:
        """
        Seed of all random numbers.
        """
