"""Stages: machines from TOML, events, what agents decide, and a run that is saved and restored."""

import pytest

import claque

MACHINE = """machine = "m"
[variables]
heard = 0
[crowd]
quiet = true
[events]
call = 1
[states.waits]
initial = true
enter = [ { play = "stand" } ]
transitions = [ { on = "call", if = "crowd.quiet", to = "claps", do = [ { set = "heard", to = "heard + value" } ] } ]
[states.claps]
enter = [ { play = "applaud", fade = 0.2 }, { call = "note", value = "heard" } ]
transitions = [ { after = [1, 2], to = "waits" } ]
"""


@pytest.fixture
def stage(crowd, citizen):
    with claque.Stage(crowd, seed=3) as made:
        made.shown = []
        made.action("note", show=lambda actor, time_s, value: made.shown.append((actor, time_s, value)))
        machine = made.machine(MACHINE, citizen)
        made.people = [
            made.agent(machine, crowd.add(citizen, (i, 0, 5)), (i, 0, 5), "left" if i < 3 else "right", i)
            for i in range(6)
        ]
        yield made


def test_events_reach_those_that_they_are_for(stage):
    stage.send("call", 1.02, value=2, to_class="left")
    stage.send("call", 1.52, value=5, radius_m=1.5, position=(5, 0, 5))
    stage.step(2)
    assert [agent.get("heard") for agent in stage.people] == [2, 2, 2, 0, 5, 5]
    assert stage.people[4].state == "claps" and stage.people[3].state == "waits"
    assert stage.shown == []
    applied = stage.apply(1.6)
    assert applied.commands == 6 + 10 and applied.refused == 0
    assert sorted(value for _, _, value in stage.shown) == [2, 2, 2, 5, 5]
    assert stage.shown[0][1] == 1.02


def test_variables_views_and_timetables_come_from_outside(stage):
    stage.timetable("[[event]]\nat = 0.5\nsend = \"call\"\nvalue = 1\nevery = 4\n", offset_s=1)
    stage.tell_view(stage.people[:1], [False], 0.5)
    stage.set("quiet", 0, 5)
    stage.people[1].place((90, 0, 0))
    stage.people[2].remove()
    stage.step(9)
    assert stage.get("quiet") == 0 and stage.people[0].get("heard") == 1
    assert not stage.people[0].info.in_view and stage.info.agents == 5
    with pytest.raises(claque.Error) as refused:
        stage.people[2].get("heard")
    assert refused.value.status is claque.Status.STALE_ID


def test_a_restored_stage_has_the_same_future(stage):
    stage.send("call", 0.5, value=1)
    stage.step(1)
    saved = stage.save()
    stage.step(8)
    first = stage.info.hash
    stage.restore(saved)
    assert stage.info.decided_s == pytest.approx(1)
    stage.step(8)
    assert stage.info.hash == first


def test_a_wrong_machine_is_refused_by_line(stage, citizen):
    with pytest.raises(claque.Error, match="bad, line 3, column 35: there is no state 'b'"):
        stage.machine("machine = \"m\"\n[states.a]\ntransitions = [ { after = 1, to = \"b\" } ]\n", citizen, name="bad")
    with pytest.raises(TypeError):
        claque.Stage(stage.crowd, sed=3)
