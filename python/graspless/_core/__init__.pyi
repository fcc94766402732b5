"""
The C++ core of graspless. Import its rooms from `graspless`, not from here.
"""
from __future__ import annotations
from . import geometry
from . import robot
from . import collision
from . import scene
from . import planning
from . import mechanics
from . import slide
from . import pinch
from . import fingertip
from . import clasp
from . import carry
from . import perception
__all__: list[str] = ['carry', 'clasp', 'collision', 'fingertip', 'geometry', 'mechanics', 'perception', 'pinch', 'planning', 'robot', 'scene', 'slide']
