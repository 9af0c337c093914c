#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""This server and agents against others over the same wire: ratios of processor time, measured by turns.

  compare.py clients [--peer-server COMMAND] [--counts 1,5,11,22]
      a server with N clients that move all 22 joints in every cycle, so that nothing sleeps: its
      processor time per cycle, for each stepper and for the peer
  compare.py match --peer-server COMMAND --peer-agent COMMAND [--players 5]
      simulated seconds per processor second of server and agents: our own 3-vs-2 match under
      each stepper against the peer's server with the peer's agents in PlayOn

  compare.py ratios
      what this system makes of the machine: exact whole match against a bare loop of dWorldStep over
      robots that play (target bare_step), fast against exact, two jobs pinned to a core each against one

COMMANDs start programs that stay in the foreground; {agent} and {monitor} are the server's ports,
{port}, {unum} and {team} the agent's. Processor time is user and system time of a command's processes,
from /proc, so that a busy machine falsifies little; sides take turns, and medians of the rounds are
compared. The peer must wait for agents' (syn) and not for the clock.
"""
import argparse
import json
import math
import os
import re
import selectors
import shlex
import signal
import socket
import statistics
import struct
import subprocess
import sys
import tempfile
import time

PREFIX = struct.Struct(">I")
JOINTS = ["he1", "he2"] + [f"{side}{limb}{k}" for side in "lr" for limb, last in (("ae", 4), ("le", 6))
                           for k in range(1, last + 1)]
CYCLE_S = 0.02


class Connection:
    def __init__(self, port, patience=20.0):
        end = time.monotonic() + patience
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port), timeout=patience)
                break
            except OSError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.2)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.bytes = b""

    def send(self, text):
        self.socket.sendall(PREFIX.pack(len(text)) + text.encode("latin-1"))

    def holds_frame(self):
        return len(self.bytes) >= 4 and len(self.bytes) >= 4 + PREFIX.unpack(self.bytes[:4])[0]

    def receive(self):
        while not self.holds_frame():
            arrived = self.socket.recv(65536)
            if not arrived:
                raise EOFError("the server closed the connection")
            self.bytes += arrived
        length = PREFIX.unpack(self.bytes[:4])[0]
        payload, self.bytes = self.bytes[4:4 + length], self.bytes[4 + length:]
        return payload.decode("latin-1")


class Programs:
    """Started commands, each in a process group of its own; their processor time; their end."""

    def __init__(self):
        self.children = []

    def start(self, command, **environment):
        self.children.append(subprocess.Popen(
            shlex.split(command), start_new_session=True, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=dict(os.environ, **environment)))

    def seconds(self):
        groups = {child.pid for child in self.children}
        nanoseconds = 0
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            try:
                with open(f"/proc/{entry}/stat") as file:
                    fields = file.read().rsplit(")", 1)[1].split()
                if int(fields[2]) in groups:  # process group
                    for task in os.listdir(f"/proc/{entry}/task"):
                        with open(f"/proc/{entry}/task/{task}/schedstat") as file:
                            nanoseconds += int(file.read().split()[0])
            except OSError:  # it has ended
                continue
        return 1e-9 * nanoseconds

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for child in reversed(self.children):
            for number in (signal.SIGTERM, signal.SIGKILL):
                try:
                    os.killpg(child.pid, number)
                except ProcessLookupError:
                    pass
                try:
                    child.wait(10)
                    break
                except subprocess.TimeoutExpired:
                    continue


def free_ports():
    """Two neighbours: the reference's default ports differ by a hundred, but any two do."""
    while True:
        with socket.socket() as one:
            one.bind(("127.0.0.1", 0))
            port = one.getsockname()[1]
            with socket.socket() as two:
                try:
                    two.bind(("127.0.0.1", port + 1))
                    return port, port + 1
                except OSError:
                    continue


def our_server(binaries, stepper, players):
    return (f"{binaries}/k3d-server --agent-port {{agent}} --server-port {{monitor}} --pace fast --log-level error"
            f" --stepper {stepper} --set soccer.type_quotas=false"
            f" --set pace.lobby_left={(players + 1) // 2} --set pace.lobby_right={players // 2}")


def client_round(command, players, cycles, warm_up):
    """Processor microseconds of the server per cycle."""
    agent, monitor = free_ports()
    with Programs() as programs:
        programs.start(command.format(agent=agent, monitor=monitor))
        crowd, frames, greeted = [], [], []
        waiting = selectors.DefaultSelector()

        def answer_until(enough):
            """As agents do: a reply to what has come, whenever it comes."""
            silent = 0
            while not enough():
                ready = waiting.select(2.0)
                silent = 0 if ready else silent + 1
                if silent == 20:
                    raise TimeoutError(f"the server is silent after {frames} frames")
                for k in range(len(crowd) if silent else 0):  # a (syn) may get lost while others join
                    crowd[k].send("(syn)")
                for k in (key.data for key, _ in ready):
                    crowd[k].receive()
                    frames[k] += 1
                    while crowd[k].holds_frame():
                        crowd[k].receive()
                        frames[k] += 1
                    crowd[k].send(moves(frames[k]) if greeted[k] else greeting(k))
                    greeted[k] = True

        for k in range(players):  # one after another: not every server takes them all at once
            crowd.append(Connection(agent))
            frames.append(0)
            greeted.append(False)
            crowd[k].send("(scene rsg/agent/nao/nao.rsg)(syn)")
            waiting.register(crowd[k].socket, selectors.EVENT_READ, k)
            answer_until(lambda: frames[k] >= 2)
        answer_until(lambda: min(frames) >= warm_up)
        first, before = frames[0], programs.seconds()
        answer_until(lambda: frames[0] >= first + cycles)
        return 1e6 * (programs.seconds() - before) / (frames[0] - first)


def greeting(k):
    return f"(init (unum {k // 2 + 1})(teamname {'Reds' if k % 2 == 0 else 'Blues'}))(syn)"


def moves(frame):
    rate = 0.5 * math.sin(0.1 * frame)
    return "".join(f"({joint} {rate:.3f})" for joint in JOINTS) + "(syn)"


def clients(options):
    sides = ["exact", "fast"] + (["peer"] if options.peer_server else [])
    print(f"processor time of the server, us per cycle; N clients that move all joints; "
          f"medians of {options.rounds} rounds")
    print(f"{'clients':>7}" + "".join(f"{side:>10}" for side in sides)
          + "".join(f"{'peer/' + side:>12}" for side in sides[:-1] if sides[-1] == "peer"))
    cost = {}
    for players in options.counts:
        times = {side: [] for side in sides}
        for _ in range(options.rounds):
            for side in sides:
                command = (options.peer_server if side == "peer"
                           else our_server(options.binaries, side, players))
                cycles = options.cycles * (5 if side == "fast" else 1)
                times[side].append(client_round(command, players, cycles, 60))
        cost[players] = {side: statistics.median(times[side]) for side in sides}
        row = cost[players]
        print(f"{players:>7}" + "".join(f"{row[side]:>10.0f}" for side in sides)
              + "".join(f"{row['peer'] / row[side]:>12.2f}" for side in sides[:-1] if "peer" in row),
              flush=True)
    least, most = min(options.counts), max(options.counts)
    if least < most:
        print(f"a client's cost among {most} against one among {least}: " + ", ".join(
            f"{side} {cost[most][side] / most / (cost[least][side] / least):.2f}" for side in sides))


class OwnMatch:
    """A match of ours that has been started; its simulated seconds and the processor's, start and end included."""

    def __init__(self, options, stepper, seed, core=None):
        self.results = tempfile.NamedTemporaryFile(suffix=".jsonl")
        command = [f"{options.binaries}/k3d-optimizer", "match", "--no-viewer", "--pace", "fast",
                   "--episodes", str(options.episodes), "--seed", str(seed), "--results", self.results.name,
                   "--set", f"server:physics.stepper={stepper}"]
        pin = (lambda: os.sched_setaffinity(0, {core})) if core is not None else None
        self.began = time.monotonic()
        self.child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=pin)

    def end(self):
        """Simulated s, processor s, wall s."""
        _, status, used = os.wait4(self.child.pid, 0)
        wall = time.monotonic() - self.began
        self.child.returncode = os.waitstatus_to_exitcode(status)
        if self.child.returncode != 0:
            raise RuntimeError(f"{' '.join(self.child.args)}: exit code {self.child.returncode}")
        with open(self.results.name) as lines:
            # Three seconds of BeforeKickOff come on top of each.
            simulated = sum(json.loads(line)["hold_time_s"] + 3.0 for line in lines)
        return simulated, used.ru_utime + used.ru_stime, wall


def own_match(options, stepper, seed, core=None):
    """Simulated seconds per processor second."""
    simulated, processor, _ = OwnMatch(options, stepper, seed, core).end()
    return simulated / processor


def game_time(monitor):
    return float(re.search(r"\(time ([^)]*)\)", monitor.receive()).group(1))


def peer_match(options, seconds):
    """The same of the peer, from PlayOn on: its start is not counted."""
    agent, monitor_port = free_ports()
    with Programs() as programs:
        programs.start(options.peer_server.format(agent=agent, monitor=monitor_port))
        monitor = Connection(monitor_port)
        for k in range(options.players):
            team, unum = ("Reds", k // 2 + 1) if k % 2 == 0 else ("Blues", k // 2 + 1)
            programs.start(options.peer_agent.format(port=agent, unum=unum, team=team, host="127.0.0.1"))
            began = time.monotonic()
            while time.monotonic() - began < options.join_s:
                monitor.receive()
        monitor.send("(playMode PlayOn)")
        start = game_time(monitor)
        while game_time(monitor) < start + 1.0:
            pass
        start, before = game_time(monitor), programs.seconds()
        while (now := game_time(monitor)) < start + seconds:
            pass
        return (now - start) / (programs.seconds() - before)


def match(options):
    speed = {"exact": [], "fast": [], "peer": []}
    for k in range(options.rounds):
        for stepper in ("exact", "fast"):
            speed[stepper].append(own_match(options, stepper, options.seed + 10 * k))
        speed["peer"].append(peer_match(options, options.peer_s))
    median = {side: statistics.median(values) for side, values in speed.items()}
    print(f"simulated s per processor s of server and {options.players} agents, medians of {options.rounds} rounds")
    print(f"{'':>8}{'median':>10}{'least':>10}{'most':>10}{'of peer':>10}")
    for side, values in speed.items():
        print(f"{side:>8}{median[side]:>10.2f}{min(values):>10.2f}{max(values):>10.2f}"
              f"{median[side] / median['peer']:>10.2f}")


def bare_speed(options, seed):
    out = subprocess.run([f"{options.binaries}/bare_step", str(seed)], check=True, capture_output=True, text=True)
    return CYCLE_S / (1e-6 * float(out.stdout.split()[1]))


def ratios(options):
    """Each round all kinds on the same seeds, pinned to a core, so that they differ in nothing else."""
    cores = sorted(os.sched_getaffinity(0))[:2]
    rounds = {name: [] for name in ("bare", "exact", "fast", "exact/bare", "fast/exact", "two/one", "two/one wall")}
    for k in range(options.rounds):
        seed = options.seed + 10 * k
        os.sched_setaffinity(0, {cores[0]})
        row = {"bare": bare_speed(options, seed), "exact": own_match(options, "exact", seed, cores[0]),
               "fast": own_match(options, "fast", seed, cores[0])}
        row["exact/bare"], row["fast/exact"] = row["exact"] / row["bare"], row["fast"] / row["exact"]
        os.sched_setaffinity(0, set(cores))
        if len(cores) == 2:
            simulated, processor, wall = OwnMatch(options, "fast", seed, cores[0]).end()
            both = [job.end() for job in [OwnMatch(options, "fast", seed, core) for core in cores]]
            row["two/one"] = sum(s / p for s, p, _ in both) / (simulated / processor)
            row["two/one wall"] = sum(s for s, _, _ in both) / max(w for _, _, w in both) / (simulated / wall)
        for name, value in row.items():
            rounds[name].append(value)
    print(f"3 keepers against 2 takers, {options.episodes} episodes a round, medians of {options.rounds} rounds")
    for name, what in (("bare", "simulated s per processor s of a bare exact step"),
                       ("exact", "of the whole system, exact"), ("fast", "of the whole system, fast"),
                       ("exact/bare", "ratio"), ("fast/exact", "ratio"),
                       ("two/one", "two jobs on a core each against one, per processor s"),
                       ("two/one wall", "the same per wall s, which other load falsifies")):
        if rounds[name]:
            values = rounds[name]
            print(f"{name:>13}{statistics.median(values):>8.2f}  ({min(values):.2f} to {max(values):.2f})  {what}")


def main():
    here = os.path.dirname(os.path.realpath(__file__))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["clients", "match", "ratios"])
    parser.add_argument("--peer-server", default="")
    parser.add_argument("--peer-agent", default="")
    parser.add_argument("--binaries", default=os.path.join(here, "../../build/release/bin"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--counts", type=lambda text: [int(n) for n in text.split(",")], default=[1, 5, 11, 22])
    parser.add_argument("--cycles", type=int, default=300, help="of a round of clients; the fast stepper's has five times as many")
    parser.add_argument("--players", type=int, default=5)
    parser.add_argument("--episodes", type=int, default=3, help="of our own match, a round")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--peer-s", type=float, default=20.0, help="simulated seconds of the peer, a round")
    parser.add_argument("--join-s", type=float, default=3.0, help="wall seconds between the starts of its agents")
    options = parser.parse_args()
    if options.what == "match" and not (options.peer_server and options.peer_agent):
        parser.error("match needs --peer-server and --peer-agent")
    {"clients": clients, "match": match, "ratios": ratios}[options.what](options)


if __name__ == "__main__":
    sys.exit(main())
