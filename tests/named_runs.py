"""Runs that a command chooses by name, one after the other, with one table at the end."""
import sys


def run_named(parser, names, known, run, table_of, path):
    """Calls run(name) for each of `names`, or of all that are known; prints the table of the results, writes it to
    `path`, and ends the program, with 1 if a result has anything in `failed`."""
    for name in names:
        if name not in known:
            parser.error(f"'{name}' is none of {', '.join(known)}")
    results = []
    for name in names or known:
        print(f"{name} ...", flush=True)
        results.append(run(name))
    text = table_of(results)
    print(text)
    path.write_text(text + "\n")
    sys.exit(1 if any(result.failed for result in results) else 0)
