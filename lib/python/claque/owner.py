"""Things that the library makes and a host ends."""

from ctypes import byref, c_void_p

from .abi import Error, library


class Closing:
    """Ended by close(), by leaving a with statement, or when it is collected."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        try:
            self.close()
        except Exception:  # the interpreter is going
            pass


class Owned(Closing):
    """One opaque thing. It holds what it was made from, so that nothing is ended before what was made from it."""

    _destroy = None  # the name of the call that ends it

    def __init__(self, pointer, *held):
        self._pointer = pointer
        self._held = held

    @property
    def handle(self):
        if not self._pointer:
            raise Error(f"this {type(self).__name__} has been closed")
        return self._pointer

    def close(self):
        """Ends it. Again is harmless; what was made from it must be closed before."""
        pointer, self._pointer = self._pointer, None
        if pointer and self._destroy:
            library().function(self._destroy, None)(pointer)
        self._held = ()


def made(name, call, *arguments_before_out):
    """What a call writes through its last argument."""
    out = c_void_p()
    call(name, *arguments_before_out, byref(out))
    return out
