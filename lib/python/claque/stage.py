"""Agents that decide (claque/stage.h, libclaque-stage): state machines from TOML, events, and steps that give commands
to a crowd."""

from ctypes import POINTER, byref, c_bool, c_double, c_size_t, c_uint32, c_void_p, cast, string_at

from . import abi, abi_stage
from .owner import Owned, made


def _text(source, name):
    """A path, or the text itself where it has a line break."""
    data = source.encode()
    if "\n" in source:
        return abi_stage.StageText(text=data, text_bytes=len(data), name=name.encode())
    return abi_stage.StageText(path=data)


class Agent:
    """What decides for one actor. `state`: the innermost state that it is in."""

    def __init__(self, stage, identity, actor):
        self.stage, self.id, self.actor = stage, identity, actor

    @property
    def info(self):
        """The clq_agent_info."""
        out = abi_stage.AgentInfo()
        abi.call("clq_stage_get_agent", self.stage.handle, self.id, byref(out))
        return out

    @property
    def state(self):
        return self.info.state.decode()

    def get(self, name):
        return self.stage.get(name, self)

    def set(self, name, value, at_s=0.0):
        self.stage.set(name, value, at_s, self)

    def place(self, position):
        """Places it for distances and radii; its actor is placed by you."""
        abi.call("clq_stage_set_place", self.stage.handle, self.id, abi.point(position))

    def remove(self):
        abi.call("clq_stage_remove_agent", self.stage.handle, self.id)


class Stage(Owned):
    """Agents of one crowd. `settings` are the members of clq_stage_def."""

    _destroy = "clq_stage_destroy"

    def __init__(self, crowd, **settings):
        definition = abi_stage.StageDef(tick_s=0.05, shares=(0.5, 0.25, 0.125, 0.125), metres_per_unit=1.0)
        for name, value in settings.items():
            if name not in dict(abi_stage.StageDef._fields_):
                raise TypeError(f"clq_stage_def has no member {name}")
            setattr(definition, name, value)
        context = crowd._held[0]
        super().__init__(made("clq_stage_create", abi.call, context.handle, byref(definition)), crowd)
        self.crowd, self._callbacks, self._templates = crowd, [], []

    def machine(self, source, *templates, name="machine"):
        """Reads a state machine for agents of these templates, from a path or from the text itself."""
        handles = (c_void_p * len(templates))(*[template.handle for template in templates])
        definition = abi_stage.MachineDef(
            source=_text(source, name), template_count=len(templates), templates=cast(handles, POINTER(c_void_p))
        )
        out = abi_stage.Id()
        abi.call("clq_stage_add_machine", self.handle, byref(definition), byref(out))
        self._templates.extend(templates)
        return out

    def action(self, name, decide=None, show=None):
        """Adds an action of yours: decide and show get (actor's index, time_s, value)."""

        def callback(function):
            if not function:
                return abi_stage.ActionCallback()
            return abi_stage.ActionCallback(
                lambda _user, call: function(call[0].actor.index1, call[0].time_s, call[0].value)
            )

        definition = abi_stage.ActionDef(name=name.encode(), decide=callback(decide), show=callback(show))
        abi.call("clq_stage_add_action", self.handle, byref(definition))
        self._callbacks.append(definition)

    def agent(self, machine, actor, position=(0, 0, 0), agent_class="", seed=0, start_s=0.0):
        definition = abi_stage.AgentDef(
            machine=machine,
            actor=actor.id,
            tmpl=actor.template.handle,
            seed=seed,
            scale=1.0,
            agent_class=agent_class.encode(),
            position=abi.point(position),
            start_s=start_s,
        )
        out = abi_stage.Id()
        abi.call("clq_stage_add_agent", self.handle, byref(definition), byref(out))
        return Agent(self, out, actor)

    def send(self, name, at_s, value=0.0, to=None, to_class=None, radius_m=0.0, position=(0, 0, 0), delay_s_per_m=0.0):
        """Sends an event to one agent, a class, a radius, or all. Any thread may."""
        event = abi_stage.StageEvent(
            name=name.encode(),
            at_s=at_s,
            value=value,
            radius_m=radius_m,
            delay_s_per_m=delay_s_per_m,
            position=abi.point(position),
            to_class=to_class.encode() if to_class else None,
        )
        if to:
            event.to = to.id
        abi.call("clq_stage_send", self.handle, byref(event))

    def timetable(self, source, offset_s=0.0):
        """Adds events from a TOML timetable."""
        abi.call("clq_stage_add_timetable", self.handle, byref(_text(source, "timetable")), c_double(offset_s))

    def get(self, name, agent=None):
        """A variable of an agent or, without one, of the crowd."""
        out = c_double()
        abi.call(
            "clq_stage_get_variable", self.handle, agent.id if agent else abi_stage.Id(), name.encode(), byref(out)
        )
        return out.value

    def set(self, name, value, at_s=0.0, agent=None):
        abi.call(
            "clq_stage_set_variable",
            self.handle,
            agent.id if agent else abi_stage.Id(),
            name.encode(),
            c_double(value),
            c_double(at_s),
        )

    def tell_view(self, agents, in_view, at_s):
        """Tells which agents have come into view (True) or left it."""
        ids = (abi_stage.Id * len(agents))(*[agent.id for agent in agents])
        abi.call(
            "clq_stage_tell_view",
            self.handle,
            ids,
            (c_bool * len(agents))(*in_view),
            c_uint32(len(agents)),
            c_double(at_s),
        )

    def step(self, until_s):
        """Decides up to a time."""
        abi.call("clq_stage_step", self.handle, c_double(until_s))

    def apply(self, time_s):
        """Gives the crowd what has been decided up to a time; returns the clq_stage_applied."""
        out = abi_stage.StageApplied()
        abi.call("clq_stage_apply", self.handle, self.crowd.handle, c_double(time_s), byref(out))
        return out

    @property
    def info(self):
        """The clq_stage_info."""
        out = abi_stage.StageInfo()
        abi.call("clq_stage_get_info", self.handle, byref(out))
        return out

    def save(self):
        """The stage as bytes."""
        data = bytearray()

        def take(_user, piece, size):
            data.extend(string_at(piece, size))
            return 0

        write = abi_stage.WriteFunction(take)
        abi.call("clq_stage_save", self.handle, write, None)
        return bytes(data)

    def restore(self, data):
        """Back to saved bytes, in a stage that was made the same way."""
        abi.call("clq_stage_restore", self.handle, self.crowd.handle, data, c_size_t(len(data)))
