"""Crowds of individuals on fixed-function OpenGL 1.1: claque's C API for Python, with NumPy views.

Context, then Template, Crowd, View; Offscreen and Renderer where pictures are wanted. Everything is a context manager and
is also ended when it is collected, children before parents. A call that fails raises claque.Error, with the library's own
sentence and its status. What is said in include/claque holds here too; units carry over.
"""

from .abi import Error, Status, library_paths
from .context import Context
from .crowd import Actor, Crowd, View
from .offscreen import Offscreen
from .renderer import Renderer
from .template import Template

__all__ = ["Actor", "Context", "Crowd", "Error", "Offscreen", "Renderer", "Status", "Template", "View", "library_paths"]
