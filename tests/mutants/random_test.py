#!/usr/bin/env python3
"""Random mutants: which statements are found, what is changed in each, and what is left alone."""
import sys

sys.path.append(sys.path.pop(0))  # Python's own `random` comes first, which its other modules import

import importlib.util
import pathlib
import subprocess
import tempfile
import unittest

sys.dont_write_bytecode = True
import kept
from cases import Case
from operators import applied, population_of

HERE = pathlib.Path(__file__).resolve().parent


def random_py():
    """As a module; its name is that of a module of Python's own."""
    spec = importlib.util.spec_from_file_location("draw", HERE / "random.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def changes_of(text):
    return [change for _, changes in population_of(text) for change in changes]


def mutants_of(statement):
    """{kind: the texts that it becomes} of a statement in a function."""
    text = "void f()\n{\n    " + statement + "\n}\n"
    found = {}
    for change in changes_of(text):
        mutated = text[:change.start] + change.mutant + text[change.end:]
        found.setdefault(change.kind, []).append(" ".join(mutated[len("void f()\n{\n"):-3].split()))
    return found


class Operators(unittest.TestCase):
    def test_comparisons_are_reversed_and_those_of_integers_moved_by_one(self):
        self.assertEqual(mutants_of("if (a < b) return;"), {"comparison": ["if (a >= b) return;"]})
        self.assertEqual(mutants_of("if (a.size() <= b) return;"),
                         {"comparison": ["if (a.size() > b) return;"], "bound": ["if (a.size() < b) return;"]})

        self.assertEqual(mutants_of("if (n > 3) return;")["bound"], ["if (n >= 3) return;"])
        self.assertNotIn("bound", mutants_of("if (m[0] > m[1]) return;"))

    def test_signs_become_others(self):
        self.assertEqual(mutants_of("x = -a * b - c;"),
                         {"sign": ["x = a * b - c;", "x = -a / b - c;", "x = -a * b + c;"]})

    def test_constants_become_others(self):
        self.assertEqual(mutants_of("x = 3;"), {"constant": ["x = (3 + 1);"]})
        self.assertEqual(mutants_of("x = 0.5f;"), {"constant": ["x = (0.5f * 1.5f);"]})
        self.assertEqual(mutants_of("x = 0.0;"), {"constant": ["x = 1.0;"]})
        self.assertEqual(mutants_of("x = 1e-6;"), {"constant": ["x = (1e-6 * 1000.0);"]})
        self.assertEqual(mutants_of("return true;"), {"constant": ["return false;"]})

    def test_bounds_lose_their_one(self):
        self.assertIn("return n ;", mutants_of("return n - 1;")["bound"])

    def test_neighbouring_arguments_change_places(self):
        found = mutants_of("add(first, i, last);")
        self.assertEqual(found["swapped arguments"], ["add(i, first, last);", "add(first, last, i);"])
        self.assertNotIn("swapped arguments", mutants_of("x = std::max(a, b);"))

    def test_calls_and_sums_are_dropped(self):
        self.assertEqual(mutants_of("list.clear();"), {"dropped call": [""]})
        self.assertEqual(mutants_of("sum += x;"), {"dropped +=": ["", "sum = x;"]})

    def test_min_is_max_and_both_is_either(self):
        self.assertEqual(mutants_of("x = std::min(a, b);"), {"min for max": ["x = std::max(a, b);"]})
        self.assertEqual(mutants_of("return a && b;"), {"&& for ||": ["return a || b;"]})

    def test_statements_of_lambdas_and_classes_are_found(self):
        text = ("namespace n {\nstruct S {\n    int size() const { return a + b; }\n    int a{3};\n};\n"
                "void f(V &v)\n{\n    each(v, [&](int i) {\n        sum += i;\n    });\n}\n}  // namespace n\n")
        self.assertEqual({change.kind for change in changes_of(text)},
                         {"sign", "constant", "dropped call", "dropped +="})

    def test_types_texts_and_names_are_left_alone(self):
        for text in ('#include "a < b"\n', "// a < b\n", "enum E { a = 1 };\n", "static_assert(sizeof(int) == 4);\n",
                     "template <int N = 3>\nstruct A;\n", "using B = std::array<float, 3>;\n"):
            self.assertEqual(changes_of(text), [], text)
        for text in ('refuse("more than " + text_of(n + 1));', 'fail(status, "%d of %d", n + 1, m - 1);'):
            self.assertEqual(set(mutants_of(text)) - {"dropped call", "swapped arguments"}, set(), text)
        self.assertEqual(mutants_of("std::array<float, 3> a;"), {})
        self.assertEqual(mutants_of("switch (a) { case 3: break; }"), {})


class Draws(unittest.TestCase):
    def drawn(self, *options):
        command = [sys.executable, str(HERE / "random.py"), "--list", *options]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()

    def test_depend_on_the_seed_and_begin_alike(self):
        few = self.drawn("--seed", "one", "--count", "3", "--area", "lib/math")
        many = self.drawn("--seed", "one", "--count", "8", "--area", "lib/math")
        self.assertEqual((len(few), len(many)), (3, 8))
        self.assertEqual(few, many[:3])
        self.assertNotEqual(many, self.drawn("--seed", "two", "--count", "8", "--area", "lib/math"))

    def test_are_of_one_area_or_of_all_but_those_that_are_drawn_apart(self):
        for line in self.drawn("--seed", "one", "--count", "50", "--area", "lib/math"):
            self.assertRegex(line, r"^lib/math/[\w/]+\.(cpp|h):\d+  ")
        everywhere = self.drawn("--seed", "one", "--count", "1000")
        self.assertEqual(len({line.split("/")[0] for line in everywhere}), 4)
        self.assertEqual([line for line in everywhere if line.startswith("lib/figures/")], [])
        of_an_area = self.drawn("--seed", "one", "--count", "20", "--area", "any")
        areas = [line.split(":")[0] for line in (HERE / "areas.txt").read_text().splitlines() if line[:1] != "#"]
        self.assertTrue(any(all(line.startswith(area + "/") for line in of_an_area) for area in areas))

    def test_have_areas_whose_folders_exist(self):
        root = HERE.parent.parent
        for line in (HERE / "areas.txt").read_text().splitlines():
            if line[:1] != "#":
                area, _, tests = line.partition(":")
                for folder in [area, *(f"tests/{one}" for one in tests.split())]:
                    self.assertTrue((root / folder).is_dir(), folder)


class EqualOnes(unittest.TestCase):
    def test_exist_and_have_a_reason(self):
        lines = (HERE / "equal.txt").read_text().splitlines()
        known = {}
        for line, after in zip(lines, lines[1:] + [""]):
            if line[:1] in ("#", " ", ""):
                continue
            file = line.split("  ")[0]
            if file not in known:
                text = (HERE.parent.parent / file).read_text()
                known[file] = {f"{file}  {change.kind}: {change.what}" for change in changes_of(text)}
            self.assertIn(line, known[file])
            self.assertRegex(after, r"^ +\S", line)


class Builds(unittest.TestCase):
    SOURCE = """#include <cstdio>
constexpr int three = 3;
int twice(int n)
{
    int sum = 0;
    for (int i = 0; i < 2; ++i) sum += n;
    if (sum > 100) sum = -1;
    else std::puts("small");
    auto more = [&](int k) { return k + sum; };
    return more(three);
}
int main() { return twice(4); }
"""

    def run_with(self, program, mutant):
        reached = program.with_name("reached")
        reached.unlink(missing_ok=True)
        environment = {"CLAQUE_MUTANT": str(mutant), "CLAQUE_MUTANTS_REACHED": str(reached)}
        status = subprocess.run([str(program)], env=environment, capture_output=True).returncode
        return status, set(map(int, reached.read_text().split()))

    def test_hold_every_change_and_tell_which_places_are_reached(self):
        changes = [changes[0] for _, changes in population_of(self.SOURCE)]
        with tempfile.TemporaryDirectory() as folder:
            source, program = pathlib.Path(folder) / "a.cpp", pathlib.Path(folder) / "a"
            source.write_text(f'#include "{HERE}/switch.h"\n' + applied(self.SOURCE, list(enumerate(changes, 1))))
            subprocess.run(["c++", "-std=c++17", "-w", "-Werror=vla", str(source), "-o", str(program)], check=True)
            status, reached = self.run_with(program, 0)
            self.assertEqual(status, 11)
            by_what = {change.what.split(" in ")[0] + f" at {change.line}": number
                       for number, change in enumerate(changes, 1)}
            self.assertEqual(self.run_with(program, by_what["3 -> (3 + 1) at 2"])[0], 12)
            self.assertEqual(self.run_with(program, by_what["`sum += n` left out at 6"])[0], 3)
            self.assertEqual(self.run_with(program, by_what["+ -> - at 9"])[0], (3 - 8) % 256)
            self.assertEqual(set(by_what.values()) - reached, {by_what["- left out of `sum = -1` at 7"]})


class Errors(unittest.TestCase):
    def test_name_a_header_by_either_path(self):
        draw = random_py()
        errors = """/a/mutants/tree/lib/track/track_file.cpp:19:48: error: not usable in a constant expression
In file included from /a/mutants/tree/lib/track/track_file.cpp:1:
../../lib/track/track_file.h:10:40: note: was not initialized with a constant expression
../../../elsewhere/a.h:3:1: note: no file of the copy
"""
        self.assertEqual(draw.places_named(errors),
                         {("lib/track/track_file.cpp", "19"), ("lib/track/track_file.h", "10")})


class Reports(unittest.TestCase):
    def test_let_a_draw_go_on_and_refuse_another(self):
        draw = random_py()
        changes = [changes[0] for _, changes in population_of(Builds.SOURCE)][:3]
        mutants = [draw.Mutant("a.cpp", change) for change in changes]
        mutants[0].result, mutants[0].remark, mutants[0].ran = "failed", "A.B", ["A.C", "A.B"]
        mutants[2].result = "UNREACHED"
        with tempfile.TemporaryDirectory() as folder:
            report, of = pathlib.Path(folder) / "report.json", {"seed": "s", "area": None, "count": 3, "files": "f"}
            kept.write_report(report, of, mutants, [])
            again = [draw.Mutant("a.cpp", change) for change in changes]
            self.assertEqual(kept.take_report(report, of, again), 2)
            self.assertEqual([(one.result, one.remark, one.ran) for one in again],
                             [(one.result, one.remark, one.ran) for one in mutants])
            draw.judge(again[0], [], set(), pathlib.Path(folder))
            self.assertEqual(again[0].result, "failed")
            for key in of:
                with self.assertRaises(SystemExit):
                    kept.take_report(report, dict(of, **{key: "other"}), again)
            self.assertEqual([file.name for file in pathlib.Path(folder).iterdir()], ["report.json"])


class Baselines(unittest.TestCase):
    def test_are_kept_for_the_same_draw_alone(self):
        draw = random_py()
        with tempfile.TemporaryDirectory() as folder:
            kept.BASELINE = pathlib.Path(folder) / "baseline.json"
            test = {"name": "A.B", "command": ["sh", "-c", "echo 7 > $CLAQUE_MUTANTS_REACHED"], "properties": []}
            test["properties"].append({"name": "WORKING_DIRECTORY", "value": folder})
            fails = {"name": "A.C", "command": ["false"], "properties": test["properties"]}
            cases = [Case(test, folder), Case(fails, folder)]
            workers = draw.Workers(1)
            self.assertEqual([case.name for case in draw.baseline(cases, workers, {"seed": "s"})], ["A.B"])
            again = [Case(dict(test, command=["false"]), folder), Case(fails, folder)]
            known = draw.baseline(again, workers, {"seed": "s"})
            self.assertEqual([(case.name, case.reached) for case in known], [("A.B", frozenset({7}))])
            self.assertEqual(draw.baseline(again, workers, {"seed": "t"}), [])


class Cases(unittest.TestCase):
    def happened(self, script, limit_s=20, **properties):
        test = {"name": "Suite.Case", "command": ["sh", "-c", script],
                "properties": [{"name": name, "value": value} for name, value in properties.items()]}
        with tempfile.TemporaryDirectory() as folder:
            test["properties"].append({"name": "WORKING_DIRECTORY", "value": folder})
            return Case(test, folder).run(pathlib.Path(folder), limit_s, 7)[0]

    def test_are_judged_as_ctest_does(self):
        self.assertEqual(self.happened("exit 0"), "passed")
        self.assertEqual(self.happened("exit 3"), "failed")
        self.assertEqual(self.happened("kill -9 $$"), "crashed")
        self.assertEqual(self.happened("sleep 60", 0.2), "endless")
        self.assertEqual(self.happened("exit 77", SKIP_RETURN_CODE=77), "skipped")
        self.assertEqual(self.happened("echo '[  PASSED  ] 0 tests'", SKIP_REGULAR_EXPRESSION=["0 tests"]), "skipped")
        self.assertEqual(self.happened("echo good; exit 1", PASS_REGULAR_EXPRESSION=["good"]), "passed")
        self.assertEqual(self.happened("exit 1", WILL_FAIL=True), "passed")
        self.assertEqual(self.happened('test "$A$B$CLAQUE_MUTANT" = 127', ENVIRONMENT=["A=1"],
                                       ENVIRONMENT_MODIFICATION=["B=set:2"]), "passed")


if __name__ == "__main__":
    unittest.main()
