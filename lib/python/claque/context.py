"""claque/context.h."""

from ctypes import byref, sizeof

from . import abi
from .owner import Owned, made


class Context(Owned):
    """Everything else is made from one. `log`: a list that gets the library's warnings as (level, text)."""

    _destroy = "clq_context_destroy"

    def __init__(self):
        self.log = []
        self._write = abi.LogWrite(lambda _user, level, text: self.log.append((level, text.decode("utf-8", "replace"))))
        definition = abi.ContextDef()
        definition.struct_bytes = sizeof(definition)
        definition.log.write = self._write
        super().__init__(made("clq_context_create", abi.call, byref(definition)), self._write)
