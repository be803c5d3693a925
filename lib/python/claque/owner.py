"""Base classes of objects that the library creates and a host destroys."""

from ctypes import byref, c_void_p

from .abi import Error, library
from .heard import heard


class Closing:
    """Closed by close(), at the end of a with statement, or when it is garbage-collected."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        try:
            self.close()
        except Exception:  # the interpreter is shutting down
            pass


class Owned(Closing):
    """One opaque object. It holds the objects it was created from, so that they outlive it."""

    _destroy = None  # the name of the function that destroys it

    def __init__(self, pointer, *held):
        self._pointer = pointer
        self._held = held
        heard.warn()  # an exception now closes the object

    @property
    def handle(self):
        if not self._pointer:
            raise Error(f"this {type(self).__name__} has been closed")
        return self._pointer

    def close(self):
        """Destroys the object; a second call does nothing. Objects created from it must be closed before."""
        pointer, self._pointer = self._pointer, None
        if pointer and self._destroy:
            library().function(self._destroy, None)(pointer)
        self._held = ()


def made(name, call, *arguments_before_out):
    """Returns the pointer that a call writes through its last argument."""
    out = c_void_p()
    call(name, *arguments_before_out, byref(out))
    return out
