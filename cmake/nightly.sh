#!/bin/sh
# nightly.sh JOBS [STEP...]: runs the checks that seldom fail and take too long for CI. Each step is a target of make,
# by default all of `steps`; a failure ends no other step. Each ends with one line, and all with one table; their logs
# are in out/nightly. The exit status is 1 if a step failed. A step takes LIMIT_S seconds at most (four hours).
set -eu
jobs=$1
shift
steps='test-asan test-scalar test-threads test-bits test-queues fuzz faults test-mutants test-random soak coverage check
test-gl test-webgl test-hosts test-guest test-machines
test-bare test-few test-package test-wheel test-reproducible'
[ $# -gt 0 ] || set -- $steps
limit_s=${LIMIT_S:-14400}
out=out/nightly
mkdir -p "$out"
table=$out/table.md
printf '| step | result | minutes | its last line |\n|---|---|---|---|\n' >"$table"
failed=''

for step; do
    log=$out/$step.log
    began=$(date +%s)
    status=0
    # The others pass over these two: five minutes of each fuzzer, and 300 of the written mutants, which the committed
    # tree chooses.
    timeout -k 60 "$limit_s" make --no-print-directory "$step" JOBS="$jobs" SECONDS=300 MUTANTS='--some 300' \
        >"$log" 2>&1 </dev/null || status=$?
    case "$status $(grep -c '^skipped: ' "$log")" in
    "0 0") result=passed ;;
    0*) result=skipped ;;  # all or some of it, for want of things that the log names
    124* | 137*) result="not ended after $limit_s s" ;;
    *) result=failed ;;
    esac
    [ "$status" = 0 ] || failed="$failed $step"
    seconds=$(($(date +%s) - began))
    last=$(grep -v '^[[:space:]]*$\|^make.* Error [0-9]*$' "$log" | tail -n 1 | tr '|' '/' | cut -c 1-100)
    echo "nightly: $step $result after $seconds s"
    echo "| $step | $result | $((seconds / 60)).$((seconds % 60 / 6)) | $last |" >>"$table"
done
cat "$table"
[ -z "$failed" ] || {
    echo "failed:$failed (logs in $out)"
    exit 1
}
