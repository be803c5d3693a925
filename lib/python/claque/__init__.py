"""Crowds of individuals on fixed-function OpenGL 1.1: claque's C API for Python, with NumPy views.

Create a Context, then Template, Crowd and View; for pictures also Offscreen and Renderer. Every object is a context
manager and is also closed when it is garbage-collected, children before parents. A failing call raises claque.Error
with the library's message and status. The documentation and units of include/claque hold here too.
"""

from .context import Context
from .crowd import Actor, Crowd, View
from .errors import Error, Status
from .labels import Sample, labels
from .offscreen import Offscreen
from .places import library_paths
from .records import Record
from .renderer import Renderer
from .samples import VariedSample, samples
from .scene import Scene
from .stage import Agent, Stage
from .template import Template, ZoneMap
from .tracks import Locomotion, Track, Tracks, find_passings
from .trajectories import Area, Trajectories

__all__ = ["Actor", "Agent", "Area", "Context", "Crowd", "Error", "Locomotion", "Offscreen", "Record", "Renderer",
           "Sample", "Scene", "Stage", "Status", "Template", "Track", "Tracks", "Trajectories", "VariedSample",
           "View", "ZoneMap", "find_passings", "labels", "library_paths", "samples"]
