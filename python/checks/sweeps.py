"""Shows that a sweep has the same bytes however it was run: `cargo xtask sweeps`.

2,000 problems in one process; on Dask with two workers, one of which is killed in the middle; in 40 shards
of the command `tautline`, with kill -9 at ten random moments; and on Ray, if asked.
"""

import argparse
import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

from tautline_geodesics import sweep

SWEEP = """
[parameters]
height = 2
x = -2
y = 0.2

[metric]
cost = "1 + height*exp(-(x1^2 + x2^2))"

[from]
point = ["x", "y"]

[to]
ball = { centre = [2, -0.1], radius = 0.25 }

[solve]
n = 64

[sweep]
draws = 500
seed = 11

[sweep.vary]
height = [0.5, 1, 2, -1.5]           # with the last one, the metric is none on a circle
x = { uniform = [-3, -1] }
y = { uniform = [-1, 1] }
"""
SHARDS = 40
KILLS = 10


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--tautline", type=Path, required=True, help="the command")
    arguments.add_argument("--folder", type=Path, required=True, help="is emptied, and written to")
    arguments.add_argument("--seed", type=int, default=None, help="of the random moments")
    arguments.add_argument("--ray", action="store_true", help="also run on Ray")
    given = arguments.parse_args()
    seed = random.SystemRandom().randrange(2**32) if given.seed is None else given.seed
    print(f"seed {seed}; for the same moments: cargo xtask sweeps --seed {seed}", flush=True)
    shutil.rmtree(given.folder, ignore_errors=True)
    given.folder.mkdir(parents=True)
    os.chdir(given.folder)
    Path("sweep.toml").write_text(SWEEP)
    tautline = str(given.tautline)
    subprocess.run([tautline, "plan", "sweep.toml", "-o", "plan.csv"], check=True)
    plan = sweep.read("plan.csv")
    hashes = {
        "one process": one_process(tautline),
        "Dask, a worker killed": on_dask(plan),
        f"{SHARDS} shards, {KILLS} killed": in_shards(tautline, random.Random(seed)),
    }
    if given.ray:
        hashes["Ray"] = on_ray(plan)
    print()
    for name, sha in hashes.items():
        print(f"{name:<24} {sha}")
    if len(set(hashes.values())) != 1:
        sys.exit("the results differ")


def one_process(tautline):
    line = [tautline, "run", "plan.csv", "--to", "one", "--threads", "1", "--times", "times.csv"]
    subprocess.run(line, check=True)
    heads, values = (line.split(",") for line in Path("times.csv").read_text().splitlines())
    times = dict(zip(heads, map(float, values)))
    rate = times["problems"] / times["seconds"]
    print(f"one process: {rate:.0f} problems a second and core, {times['peak_kilobytes'] / 1024:.0f} MB")
    return sha("one/1-of-1.csv")


def on_dask(plan):
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            workers = client.run(os.getpid)
            victim = sorted(workers.values())[0]
            killer = threading.Thread(target=kill_in_the_middle, args=(victim, Path("dask")))
            begin = time.perf_counter()
            killer.start()
            paths = sweep.run_on_dask(plan, client, "dask", shards=SHARDS)
            killer.join()
            seconds = time.perf_counter() - begin
            after = client.run(os.getpid)
    if victim in after.values() or len(paths) != SHARDS:
        sys.exit("the worker was not killed")
    print(f"Dask: {len(plan) / seconds:.0f} problems a second on two workers, {victim} killed")
    sweep.merge("dask", "dask.csv")
    return sha("dask.csv")


def kill_in_the_middle(process, folder):
    """Kills a process once a third of the shards is done, and says how many were then."""
    while len(done := [*folder.glob("[!.]*.csv")]) < SHARDS // 3:
        time.sleep(0.001)
    os.kill(process, signal.SIGKILL)
    print(f"Dask: worker {process} is killed after {len(done)} of {SHARDS} shards", flush=True)


def in_shards(tautline, chance):
    """Runs shards two at a time, and kills ten of the runs; what was killed runs again."""
    doomed = set(chance.sample(range(1, SHARDS + 1), KILLS))
    killed = 0
    waiting, running = [*range(1, SHARDS + 1)], {}
    while waiting or running:
        while waiting and len(running) < 2:
            k = waiting.pop(0)
            shard = f"{k}/{SHARDS}"
            line = [tautline, "run", "plan.csv", "--shard", shard, "--to", "shards", "--threads", "1"]
            process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            # A run takes some hundredths of a second.
            moment = time.perf_counter() + chance.uniform(0, 0.04) if k in doomed else float("inf")
            running[k] = (process, moment)
        for k, (process, moment) in [*running.items()]:
            if process.poll() is not None:
                del running[k]
                if process.returncode != 0:
                    sys.exit(f"shard {k} failed")
                if k in doomed:
                    # It was faster than the kill: it is started anew, and killed sooner.
                    Path("shards", f"{k}-of-{SHARDS}.csv").unlink()
                    waiting.insert(0, k)
            elif time.perf_counter() > moment:
                process.kill()
                process.wait()
                del running[k]
                killed += 1
                doomed.discard(k)
                waiting.append(k)
        time.sleep(0.0005)
    remains = [path for path in Path("shards").iterdir() if path.name.startswith(".")]
    print(f"shards: {killed} runs were killed, {len(remains)} drafts remain")
    if killed != KILLS or remains:
        sys.exit("expected ten kills and no drafts")
    subprocess.run([tautline, "merge", "shards", "-o", "shards.csv"], check=True)
    return sha("shards.csv")


def on_ray(plan):
    import ray

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    data = ray.data.range(len(plan)).map_batches(sweep.Batch(plan, lines=True), batch_size=50)
    rows = sorted(data.take_all(), key=lambda row: row["id"])
    ray.shutdown()
    Path("ray.csv").write_text(plan.results([row["line"] for row in rows]))
    return sha("ray.csv")


def sha(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


if __name__ == "__main__":
    main()
