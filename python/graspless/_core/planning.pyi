"""
What every planner shares: the budget of a query.
"""
from __future__ import annotations
import typing
__all__: list[str] = ['Budget']
class Budget:
    """
    All randomness and time of a query.
    """
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 10.0, iterations: typing.SupportsInt | typing.SupportsIndex | None = None, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        seconds: wall clock [s], may be inf. iterations: rounds of the main loop, None for no limit.
        
        The same seed and iterations give the same plan, bit by bit, unless the clock ends the search first.
        """
    def __repr__(self) -> str:
        ...
    def part(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex, seed: typing.SupportsInt | typing.SupportsIndex) -> Budget:
        """
        What a part of a longer query may spend: as this one, with seconds and seed of its own.
        
        stop() of either ends both.
        """
    def stop(self) -> None:
        """
        Ends the query that runs on this budget, from any thread; it returns within some 10 ms.
        
        A stopped budget stays so: later queries on it end at once.
        """
    @property
    def is_stopped(self) -> bool:
        """
        Whether stop() was called.
        """
    @property
    def iterations(self) -> int | None:
        """
        Rounds of the main loop; None for no limit.
        """
    @property
    def seconds(self) -> float:
        """
        Wall clock [s].
        """
    @property
    def seed(self) -> int:
        """
        Of all random numbers.
        """
