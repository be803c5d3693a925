"""The context (claque/context.h)."""

from ctypes import byref

from . import abi
from .owner import Owned, made


class Context(Owned):
    """All other objects are created from a context. `log`: a list of the library's warnings as (level, text)."""

    _destroy = "clq_context_destroy"

    def __init__(self):
        self.log = []
        self._write = abi.LogWrite(lambda _user, level, text: self.log.append((level, text.decode("utf-8", "replace"))))
        definition = abi.ContextDef()
        definition.log.write = self._write
        super().__init__(made("clq_context_create", abi.call, byref(definition)), self._write)
