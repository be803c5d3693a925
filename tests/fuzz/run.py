#!/usr/bin/env python3
"""run.py [--merge] [--seed N] [SECONDS [NAME...]]: builds the fuzzers (preset fuzz), runs each for SECONDS of CPU
time (default 20) from its corpus and its seeds, as many at once as JOBS says, and prints one table. --seed makes runs
alike. Exits with 1 if a fuzzer found something; the input is then in out/fuzz. --merge writes the smallest set of
inputs with the same coverage to tests/fuzz/corpus. See README.md."""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.path.join(ROOT, 'build', 'fuzz')
OUT = os.path.join(ROOT, 'out', 'fuzz')
CORPUS = os.path.join(ROOT, 'tests', 'fuzz', 'corpus')
LIMITS = [
    '-rss_limit_mb=2048',
    '-timeout=25',  # of the clock: a loaded machine takes some times its processor time
    '-max_len=16000',
    '-use_value_profile=1',
    '-print_final_stats=1',
    '-detect_leaks=1',
    '-reload=0',
]
SLOWEST_S = 25  # of processor time, for one input
MERGED_BYTES = 29000  # of one corpus in the tree


def why_not():
    """A line that names what is missing, or nothing."""
    if not shutil.which('clang++'):
        return 'skipped: the fuzzers need clang++ (cmake/setup.sh fuzz installs it)'
    probe = subprocess.run(
        ['clang++', '-fsanitize=fuzzer,address', '-x', 'c++', '-', '-o', os.devnull],
        input='extern "C" int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long) { return 0; }',
        text=True,
        capture_output=True,
    )
    return '' if probe.returncode == 0 else 'skipped: the fuzzers need libFuzzer (cmake/setup.sh fuzz installs it)'


def jobs():
    return int(os.environ.get('JOBS') or os.cpu_count())


def build(names):
    os.makedirs(os.path.join(ROOT, 'build'), exist_ok=True)
    commands = [['cmake', '--preset', 'fuzz']] if not os.path.exists(os.path.join(BUILD, 'build.ninja')) else []
    targets = ['fuzz_' + name for name in names] + ['fuzz_seeds']
    commands.append(
        ['cmake', '--build', BUILD, '-j', str(jobs()), '--target'] + targets
    )
    for command in commands:
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            sys.exit(done.stdout[-8000:] + '\nfuzz: the fuzzers cannot be built')


def program(name):
    return os.path.join(BUILD, 'tests', 'fuzz', 'fuzz_' + name)


def cpu_seconds(pid):
    with open('/proc/%d/stat' % pid) as stat:
        fields = stat.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def folders(name):
    """New inputs go to the first of them."""
    found, seeds = os.path.join(OUT, name), os.path.join(OUT, 'seeds', name)
    os.makedirs(found, exist_ok=True)
    return [found] + [folder for folder in (os.path.join(CORPUS, name), seeds) if os.path.isdir(folder)]


def options(name):
    words = os.path.join(ROOT, 'tests', 'fuzz', 'dictionaries', name + '.dict')
    return LIMITS + (['-dict=' + words] if os.path.exists(words) else [])


def hangs(name, path):
    """Whether an input takes so much processor time that it was no loaded machine that made it slow."""
    process = subprocess.Popen([program(name), path], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    used = 0.0
    while process.poll() is None and used < SLOWEST_S:
        used = max(used, cpu_seconds(process.pid))
        time.sleep(0.05)
    process.kill()
    return used >= SLOWEST_S or process.wait() not in (0, -signal.SIGKILL)


def findings(name):
    kinds = re.escape(name) + '-(crash|leak|timeout|oom)-'
    return sorted(f for f in os.listdir(OUT) if re.match(kinds, f))


def run_for(name, seconds, seed, log):
    """Runs a fuzzer for so much processor time and returns what it used, and how it ended."""
    environment = dict(os.environ, ASAN_OPTIONS='detect_odr_violation=0:allocator_may_return_null=1')
    process = subprocess.Popen(
        [program(name), '-artifact_prefix=' + os.path.join(OUT, name + '-'), '-seed=%d' % seed]
        + options(name)
        + folders(name),
        cwd=OUT,
        stdout=log,
        stderr=subprocess.STDOUT,
        env=environment,
    )
    used = 0.0
    while process.poll() is None:
        used = max(used, cpu_seconds(process.pid))
        if used >= seconds:
            process.send_signal(signal.SIGUSR1)  # libFuzzer ends after this input
            try:
                process.wait(60)
            except subprocess.TimeoutExpired:  # it still reads its corpus: libFuzzer ends one input after 25 s
                process.kill()
                process.wait()
                return used, 0
            break
        time.sleep(0.2)
    return used, process.returncode


def fuzz(name, seconds, seed):
    """Returns a row of the table. Seed 0 is another one each time. A hang by the clock that takes little processor time
    is no finding: the fuzzer goes on for the time that is left."""
    log_path = os.path.join(OUT, name + '.log')
    for old in findings(name):
        os.remove(os.path.join(OUT, old))
    used, executions, runs, returncode = 0.0, 0, 0, 0
    while used < seconds - 1 or runs == 0:
        with open(log_path, 'w') as log:
            took, returncode = run_for(name, seconds - used, seed + runs if seed else 0, log)
        used, runs = used + took, runs + 1
        with open(log_path, errors='replace') as log:
            text = log.read()
        number = lambda pattern: (re.findall(pattern, text) or ['0'])[-1]
        done = number(r'stat::number_of_executed_units: (\d+)')
        executions += int(done if done != '0' else number(r'(?m)^#(\d+)'))
        found = findings(name)
        if not found or any('-timeout-' not in f or hangs(name, os.path.join(OUT, f)) for f in found):
            break
        for slow in found:
            os.remove(os.path.join(OUT, slow))
        returncode = 0
    found = findings(name)
    if returncode and not found:
        found = ['exit %d, see out/fuzz/%s.log' % (returncode, name)]
    return [name, '%.0f' % used, executions, number(r'\bcov: (\d+)'), number(r'\bft: (\d+)'), ' '.join(found) or '-']


def merge(name):
    """Small inputs first, as libFuzzer's merge takes them; then at most MERGED_BYTES of them."""
    merged = os.path.join(OUT, 'merged', name)
    shutil.rmtree(merged, ignore_errors=True)
    os.makedirs(merged)
    subprocess.run(
        [program(name), '-merge=1'] + [o for o in options(name) if 'value_profile' not in o] + [merged] + folders(name),
        cwd=OUT,
        check=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=dict(os.environ, ASAN_OPTIONS='detect_odr_violation=0:allocator_may_return_null=1'),
    )
    target = os.path.join(CORPUS, name)
    os.makedirs(target, exist_ok=True)
    for old in os.listdir(target):
        if not old.startswith('found-'):  # inputs that once broke a law stay
            os.remove(os.path.join(target, old))
    room = MERGED_BYTES - sum(os.path.getsize(os.path.join(target, f)) for f in os.listdir(target))
    sizes = sorted((os.path.getsize(os.path.join(merged, f)), f) for f in os.listdir(merged))
    taken = 0
    for size, file in sizes:
        if size <= room:
            shutil.copy(os.path.join(merged, file), os.path.join(target, file[:12]))
            room, taken = room - size, taken + 1
    print('%s: %d of %d inputs' % (name, taken, len(sizes)))


def main(arguments):
    merging = '--merge' in arguments
    arguments = [a for a in arguments if a != '--merge']
    seed = 0
    if '--seed' in arguments:
        at = arguments.index('--seed')
        seed = int(arguments[at + 1])
        del arguments[at : at + 2]
    seconds = float(arguments.pop(0)) if arguments and re.fullmatch(r'[0-9.]+', arguments[0]) else 20
    with open(os.path.join(ROOT, 'tests', 'fuzz', 'CMakeLists.txt')) as lists:
        known = re.search(r'set\(fuzzers ([^)]*)\)', lists.read()).group(1).split()
    names = arguments or known
    for name in names:
        if name not in known:
            sys.exit('fuzz: there is no fuzzer %s; there are %s' % (name, ' '.join(known)))
    reason = why_not()
    if reason:
        print(reason)
        return 0
    build(names)
    os.makedirs(OUT, exist_ok=True)
    subprocess.run([os.path.join(BUILD, 'tests', 'fuzz', 'fuzz_seeds'), os.path.join(OUT, 'seeds')], check=True)
    if merging:
        for name in names:
            merge(name)
        return 0
    with ThreadPoolExecutor(jobs()) as pool:
        rows = list(pool.map(lambda name: fuzz(name, seconds, seed), names))
    for row in [['fuzzer', 'seconds', 'executions', 'edges', 'features', 'findings (in out/fuzz)']] + rows:
        print('%-9s %8s %11s %7s %9s  %s' % tuple(row))
    return 1 if any(row[-1] != '-' for row in rows) else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
