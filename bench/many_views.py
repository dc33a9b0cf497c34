#!/usr/bin/python3
"""many_views.py VIEWS OUT RUN...: a made-up run of VIEWS views in OUT, from the views of real runs.

Eight views a model. One view of a hundred is a defective one of the runs, with its evidence as links; the others are
proven ones with other counts and times. `zproof report OUT -o OUT/report.html` makes the page.
"""
import copy
import json
import os
import random
import sys
from pathlib import Path


def link_evidence(source, target):
    target.mkdir(parents=True, exist_ok=True)
    for file in source.iterdir():
        if not (target / file.name).exists():
            os.link(file, target / file.name)


def made_up(view, i):
    view = copy.deepcopy(view)
    view.update(scene=f"model-{i // 8:05d}", view=f"cam{i % 8}", source=f"models/area-{i // 8 % 40:02d}/model-{i // 8:05d}.glb",
                place=i // 8, triangles=random.randrange(1000, 2_000_000),
                times={stage: round(random.random(), 6) for stage in view["times"]})
    if view["outcome"] == "proven":
        moved = random.randrange(1 + view["counts"]["agree"] // 10)
        view["counts"]["agree"] -= moved
        view["counts"]["edge"] += moved
        view["candidate_depth"]["max_error_over_bound"] = random.random()
        view["folder"] = ""
    return view


def main(count, out, runs):
    random.seed(1)
    results = [(run, json.loads((run / "results.json").read_text())) for run in runs]
    views = [(run, view) for run, result in results for view in result["views"]]
    defective = [pair for pair in views if pair[1]["outcome"] == "defective"]
    proven = [pair for pair in views if pair[1]["outcome"] == "proven"]
    head = dict(results[0][1], views=[], selection=dict(results[0][1]["selection"], scenes=(count + 7) // 8))
    out.mkdir(parents=True, exist_ok=True)
    with open(out / "results.json", "w") as file:
        file.write(json.dumps(head, indent=1)[:-len("]\n}")])
        for i in range(count):
            run, view = random.choice(defective if i % 100 == 37 else proven)
            one = made_up(view, i)
            if one["folder"]:
                one["folder"] = f"scenes/{one['scene']}-{one['view']}"
                link_evidence(run / view["folder"], out / one["folder"])
            file.write((",\n  " if i else "\n  ") + json.dumps(one, indent=1).replace("\n", "\n  "))
        file.write("\n ]\n}\n")


main(int(sys.argv[1]), Path(sys.argv[2]), [Path(run) for run in sys.argv[3:]])
