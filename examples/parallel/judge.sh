#!/bin/sh
# The shards of a plan on the machines that GNU parallel is told of (--sshlogin), two at a time on this one. Called once
# more, it makes only those that failed or were never begun; merge says which these are.
set -eu
[ -f plan.json ] || zproof plan models --of 8 -o plan.json > commands.txt
parallel --jobs 2 --joblog jobs.log --resume-failed < commands.txt
zproof merge --plan plan.json shards/* -o zproof-out
