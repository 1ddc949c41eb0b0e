#!/bin/sh
# run.sh RUN ARGUMENTS PROGRAM...: runs the programs, each as `RUN PROGRAM ARGUMENTS`, and prints a line for each case. A program with
# many cases that ends after a crash goes on with the case after it.
run=$1
arguments=$2
shift 2
limit=
if command -v timeout >/dev/null && timeout 1 true 2>/dev/null; then limit='timeout 120'; fi
gl=
for program; do
    name=${program##*/}
    name=${name%.exe}
    after=
    while :; do
        lines=$($limit $run "$program" $arguments $after 2>/dev/null </dev/null | tr -d '\r' | grep -E '^GL: |: (right|open|wrong|not run|crashed)')
        first=$(printf '%s\n' "$lines" | sed -n 's/^GL: //p' | head -n 1)
        if [ -z "$gl" ] && [ -n "$first" ]; then
            gl=$first
            printf 'GL: %s\n' "$gl"
        fi
        lines=$(printf '%s\n' "$lines" | grep -v '^GL: ')
        if [ -z "$lines" ]; then
            [ -n "$after" ] || printf '%s: crashed: it ended without a result\n' "$name"
            break
        fi
        printf '%s\n' "$lines"
        last=$(printf '%s\n' "$lines" | tail -n 1)
        case $last in
        *': crashed: signal '*) [ "$name" = all ] && after="--after ${last%%: crashed: *}" || break ;;
        *) break ;;
        esac
    done
done
