#!/usr/bin/env python3
"""A matrix of renderers and scenes shared out among machines, on paper: measured times, drawn again for as many scenes as
are asked for, and what machines do that are slow or lost. docs/scale.md shows what came out.

    simulate_shards.py RESULTS.json... [--scenes 10000] [--renderers 4] [--shards 8,64,512] [--seed 1]
"""
import argparse
import heapq
import json
import random
from pathlib import Path


def measured_scenes(files):
    """Of each scene: the seconds of its set-up, and of each of its views."""
    scenes = []
    for file in files:
        by_scene = {}
        for view in json.loads(Path(file).read_text())['views']:
            times = view['times']
            setup = times['load'] + times['reference_build']
            by_scene.setdefault(view['scene'], []).append((setup, sum(times.values()) - setup))
        scenes += [(max(s for s, _ in views), [v for _, v in views]) for views in by_scene.values()]
    return scenes


def pieces(scenes, most_s):
    """Views of a scene that stay together, as cli/plan/assignment.cpp cuts them."""
    for setup, views in scenes:
        together = 0
        for view in views:
            if together and setup + together + view > most_s:
                yield setup + together
                together = 0
            together += view
        yield setup + together


def longest_first(jobs, shards):
    """Shards as lists of jobs: each to the one that ends first."""
    heap = [(0, number) for number in range(shards)]
    assigned = [[] for _ in range(shards)]
    for job in sorted(range(len(jobs)), key=lambda i: -jobs[i]):
        end, number = heapq.heappop(heap)
        assigned[number].append(job)
        heapq.heappush(heap, (end + jobs[job], number))
    return assigned


def by_chance(jobs, shards, chance):
    assigned = [[] for _ in range(shards)]
    for job in range(len(jobs)):
        assigned[chance.randrange(shards)].append(job)
    return assigned


def makespan(assigned, true_s, speeds=None, lost=()):
    """A lost shard is begun again on a machine of usual speed when it would have ended."""
    ends = [sum(true_s[job] for job in jobs) / (speeds[number] if speeds else 1) for number, jobs in enumerate(assigned)]
    again = [ends[number] + sum(true_s[job] for job in assigned[number]) for number in lost]
    return max([*ends, *again])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('results', nargs='+')
    parser.add_argument('--scenes', type=int, default=10_000)
    parser.add_argument('--renderers', type=int, default=4)
    parser.add_argument('--shards', default='8,64,512')
    parser.add_argument('--seed', type=int, default=1)
    asked = parser.parse_args()
    chance = random.Random(asked.seed)
    measured = measured_scenes(asked.results)
    scenes = [chance.choice(measured) for _ in range(asked.scenes * asked.renderers)]
    longest = max(setup + max(views) for setup, views in scenes)
    print('| shards | bound, s | plan | times +- 30 % | hash | 2 % of half speed | the same, four shards each | 2 % lost |')
    print('|---|---|---|---|---|---|---|---|')
    for shards in map(int, asked.shards.split(',')):
        bound = max(longest, sum(setup + sum(views) for setup, views in scenes) / shards)
        jobs = list(pieces(scenes, bound))
        plan = longest_first(jobs, shards)
        true_s = [job * chance.lognormvariate(0, 0.3) for job in jobs]  # the plan knew `jobs`, and this happened
        true_bound = max(max(true_s), sum(true_s) / shards)
        speeds = [0.5 if chance.random() < 0.02 else 1 for _ in range(shards)]
        speeds[0] = 0.5
        small = longest_first(jobs, 4 * shards)  # more shards than machines: whoever is free takes the next
        free = [(0, number) for number in range(shards)]
        for one in small:
            end, number = heapq.heappop(free)
            heapq.heappush(free, (end + sum(jobs[job] for job in one) / speeds[number], number))
        lost = [number for number in range(shards) if chance.random() < 0.02] or [0]
        columns = [makespan(plan, jobs) / bound, makespan(plan, true_s) / true_bound,
                   makespan(by_chance(jobs, shards, chance), jobs) / bound, makespan(plan, jobs, speeds) / bound,
                   max(end for end, _ in free) / bound, makespan(plan, jobs, lost=lost) / bound]
        print(f'| {shards} | {bound:.0f} |', ' | '.join(f'{column:.2f}' for column in columns), '|')


if __name__ == '__main__':
    main()
