"""The context (claque/context.h)."""

from ctypes import byref

from . import abi
from .heard import heard
from .owner import Owned, made


class Context(Owned):
    """All other objects are created from a context. `log`: a list of the library's notes and warnings as (level, text).
    Warnings are Python's too (warnings.warn), after the call that gave them."""

    _destroy = "clq_context_destroy"

    def __init__(self):
        self.log = []
        self._write = abi.LogWrite(self._note)
        definition = abi.ContextDef()
        definition.log.write = self._write
        super().__init__(made("clq_context_create", abi.call, byref(definition)), self._write)

    def _note(self, _user, level, text):
        sentence = text.decode("utf-8", "replace")
        self.log.append((level, sentence))
        if level == abi.LOG_WARNING:
            heard.texts.append(sentence)
