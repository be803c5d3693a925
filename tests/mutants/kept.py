"""What a draw of random mutants keeps, so that a run that was ended goes on with it."""
import json

from copied_tree import ROOT
from mutants import fail

BASELINE = ROOT / "baseline.json"  # of the last draw with --json


def write_baseline(passed, draw):
    """`draw` names the mutants: the cases that pass reach them by their numbers."""
    reached = {case.name: [case.seconds, sorted(case.reached)] for case in passed}
    BASELINE.write_text(json.dumps(dict(draw=draw, passed=reached)))


def baseline_of(cases, draw):
    """The cases that passed in an earlier run of the same draw, or None."""
    if not draw or not BASELINE.exists():
        return None
    kept, of_name = json.loads(BASELINE.read_text()), {case.name: case for case in cases}
    if kept["draw"] != draw or not of_name.keys() >= kept["passed"].keys():
        return None
    for name, (seconds, reached) in kept["passed"].items():
        of_name[name].seconds, of_name[name].reached = seconds, frozenset(reached)
    return [of_name[name] for name in kept["passed"]]


def as_json(mutant):
    return dict(file=mutant.file, line=mutant.change.line, kind=mutant.change.kind, change=mutant.change.what,
                result=mutant.result, remark=mutant.remark, tests=mutant.ran)


def write_report(path, draw, mutants, broken):
    """The judged mutants, whole or not at all."""
    report = dict(draw, mutants=[as_json(one) for one in mutants if one.result], broken=list(map(str, broken)))
    draft = path.with_name(path.name + ".part")
    draft.write_text(json.dumps(report, indent=1) + "\n")
    draft.replace(path)


def take_report(path, draw, mutants):
    """Gives mutants the verdicts of an earlier run of the same draw; returns their number."""
    report = json.loads(path.read_text())
    if any(report.get(key) != value for key, value in draw.items()):
        fail(f"{path} holds another draw, or one of other files: remove it")
    known = {tuple(one[key] for key in ("file", "line", "kind", "change")): one for one in report["mutants"]}
    for mutant in mutants:
        change = mutant.change
        if one := known.get((mutant.file, change.line, change.kind, change.what)):
            mutant.result, mutant.remark, mutant.ran = one["result"], one["remark"], one["tests"]
    return sum(bool(mutant.result) for mutant in mutants)
