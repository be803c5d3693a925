"""A stage scenario as a script: people on benches applaud, and the applause spreads between neighbours. The script
pauses the run, saves it, tries two endings from the saved state, and goes on with the one that it likes.

    python3 rehearsal.py
"""

import claque

MACHINE = """machine = "listener"
[variables]
warm = 0.0
[events]
clap = 1
calm = 1
[states.listens]
initial = true
enter = [ { play = ["sit", "sit_lean", "sit_look"], fade = 0.3, phase = [0, 1] } ]
transitions = [ { on = "clap", if = "random(0, 1) < value", to = "applauds" } ]
[states.applauds]
enter = [
    { play = "sit_applaud", fade = 0.3 },
    { send = "clap", radius = 1.0, delay = [0.6, 1.4], value = "value * 0.8" },
]
transitions = [ { after = [6, 9], to = "listens" }, { on = "calm", to = "listens" } ]
"""

ROWS, SEATS, TICK_S, LEAD_S = 6, 12, 0.05, 1.0


def seat_people(context, crowd, stage):
    """Rows of twelve, each behind the last; returns the agents."""
    people = [claque.Template.builtin(context, name, folder=None) for name in ("citizen", "plebeian")]
    machine = stage.machine(MACHINE, *people)
    agents = []
    for i in range(ROWS * SEATS):
        place = (0.8 * (i % SEATS), 0.4 * (i // SEATS), -0.9 * (i // SEATS))
        actor = crowd.add(people[i % 2], place, clip="sit", seed=i)
        agents.append(stage.agent(machine, actor, place, seed=i))
    return agents


class Run:
    """The two flows in turn: decisions a second ahead of what is shown."""

    def __init__(self, crowd, stage, agents):
        self.crowd, self.stage, self.agents, self.time_s = crowd, stage, agents, 0.0

    def to(self, time_s):
        """Shows frames up to a time; between two calls the run is paused."""
        while self.time_s < time_s - 1e-9:
            self.time_s = round(self.time_s + TICK_S, 9)
            self.stage.step(self.time_s + LEAD_S)
            self.stage.apply(self.time_s)
            self.crowd.update(self.time_s)

    def save(self):
        return self.time_s, self.stage.save()

    def restore(self, saved):
        self.time_s = saved[0]
        self.stage.restore(saved[1])

    def send(self, event, value=1.0, place=(0, 0, 0), radius_m=0.0):
        """Sends an event; it is heard after the lead, in the next tick that is not decided."""
        self.stage.send(event, self.time_s + LEAD_S + TICK_S / 2, value, position=place, radius_m=radius_m)

    def applauding(self):
        return sum(agent.state == "applauds" for agent in self.agents)


def ending(run, event, value):
    """How many applaud four seconds after the last word."""
    run.send(event, value)
    run.to(run.time_s + 4)
    return run.applauding()


def main():
    with claque.Context() as context, claque.Crowd(context) as crowd, claque.Stage(crowd, seed=5) as stage:
        run = Run(crowd, stage, seat_people(context, crowd, stage))
        run.to(2)
        run.send("clap", 0.95, place=(4.4, 1, -2.7), radius_m=1.5)
        run.to(5)
        begun = run.applauding()
        saved = run.save()
        calm = ending(run, "calm", 0)
        run.restore(saved)
        loud = ending(run, "clap", 1)
        run.restore(saved)
        again = ending(run, "clap", 1)
        print(f"{begun} of {len(run.agents)} applaud after 5 s; 4 s later {loud} after another word, {calm} without")
        assert 0 < begun < loud and calm < begun and again == loud


if __name__ == "__main__":
    main()
