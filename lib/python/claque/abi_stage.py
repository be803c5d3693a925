"""The structs of claque/agents.h and claque/stage.h."""

from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_float, c_int, c_size_t, c_uint32,
                    c_uint64, c_void_p)

from .abi import STRUCTS, ActorId, Sized


class Id(Structure):
    _fields_ = [("index1", c_uint32)]


class StageText(Structure):
    _fields_ = [("path", c_char_p), ("text", c_char_p), ("text_bytes", c_size_t), ("name", c_char_p)]


class ActionCall(Structure):
    _fields_ = [("agent", Id), ("actor", ActorId), ("time_s", c_double), ("value", c_double), ("crowd", c_void_p)]


ActionCallback = CFUNCTYPE(None, c_void_p, POINTER(ActionCall))


class ActionDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("name", c_char_p), ("decide", ActionCallback), ("show", ActionCallback),
                ("user", c_void_p)]


class MachineDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("source", StageText), ("template_count", c_uint32),
                ("templates", POINTER(c_void_p)), ("locomotions", POINTER(c_void_p))]


class AgentDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("machine", Id), ("actor", ActorId), ("tmpl", c_void_p),
                ("agent_class", c_char_p), ("seed", c_uint64), ("position", c_double * 3), ("heading_rad", c_float),
                ("scale", c_float), ("gaze", Id), ("start_s", c_double)]


class AgentInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("actor", ActorId), ("state", c_char_p), ("depth", c_uint32),
                ("entered_s", c_double), ("transitions", c_uint64), ("position", c_double * 3), ("in_view", c_bool),
                ("walks", c_bool)]


class StageEvent(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("name", c_char_p), ("at_s", c_double), ("value", c_double), ("to", Id),
                ("sender", Id), ("to_class", c_char_p), ("radius_m", c_float), ("position", c_double * 3),
                ("delay_s_per_m", c_float)]


Clock = CFUNCTYPE(c_double, c_void_p)
WriteFunction = CFUNCTYPE(c_int, c_void_p, c_void_p, c_size_t)


class StageDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("mode", c_int), ("seed", c_uint64), ("start_s", c_double),
                ("tick_s", c_double), ("budget", c_uint32), ("budget_us", c_float), ("shares", c_float * 4),
                ("now_s", Clock), ("now_user", c_void_p), ("metres_per_unit", c_float)]


class StageApplied(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("commands", c_uint32), ("late", c_uint32), ("cut", c_uint32),
                ("refused", c_uint32), ("behind_s", c_double)]


class StageClassInfo(Structure):
    _fields_ = [("done", c_uint64), ("late", c_uint64), ("longest_wait_s", c_double), ("cost", c_uint64),
                ("waiting", c_uint32)]


class StageInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("agents", c_uint32), ("machines", c_uint32), ("decided_s", c_double)] + [
        (name, c_uint64) for name in ("ticks", "transitions", "events", "commands", "late_messages", "runaways",
                                      "tasks", "hash")] + [
        ("classes", StageClassInfo * 4)]


STRUCTS.update({
    "clq_agent": Id, "clq_stage_text": StageText, "clq_action_call": ActionCall, "clq_action_def": ActionDef,
    "clq_machine_def": MachineDef, "clq_agent_def": AgentDef, "clq_agent_info": AgentInfo,
    "clq_stage_event": StageEvent,
    "clq_stage_def": StageDef, "clq_stage_applied": StageApplied, "clq_stage_class_info": StageClassInfo,
    "clq_stage_info": StageInfo,
})
