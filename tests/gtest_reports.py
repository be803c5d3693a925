"""What GoogleTest wrote of its cases (GTEST_OUTPUT=json:FOLDER/)."""
import collections
import json


def cases_of(folder):
    """(passed, [failed], {reason: [names]}) of the reports that GoogleTest wrote into `folder`."""
    passed, failed, skipped = 0, [], collections.defaultdict(list)
    for report in sorted(folder.glob("*.json")):
        for suite in json.loads(report.read_text()).get("testsuites", []):
            for case in suite.get("testsuite", []):
                name = f"{suite['name']}.{case['name']}"
                if case.get("failures"):
                    failed.append(name)
                elif case.get("result") == "SKIPPED":
                    said = case.get("skipped") or [{}]
                    lines = said[0].get("message", "").strip().splitlines()
                    skipped[lines[-1] if lines else "no reason is given"].append(name)
                elif case.get("result") == "COMPLETED":
                    passed += 1
    return passed, failed, skipped
