"""A program's run as animated glTF and as a table in joint space."""

from __future__ import annotations

import base64
import csv
import io
import json
import struct
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.export.command import refusal, run
from tests.export.poses import BENCH, rig_of
from trs80arm.arm.contact.rotations import STRAIGHT, matrix
from trs80arm.export.chain import JOINTS
from trs80arm.export.gltf import glb, gltf
from trs80arm.export.recording import LINGERS, Look, Recording, record
from trs80arm.export.table import COLUMNS, csv_table, npz_table
from trs80arm.export.units import METRES
from trs80arm.rig import Rig

PROGRAM = "10 @STEP 20,100,-120,30,60,-80,90\n20 PRINT 1\n"
SIZES = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


@cache
def recorded(arm: str = "minimover5") -> tuple[Rig, Recording]:
    rig = rig_of(arm)
    rig.load_text(PROGRAM)
    return rig, record(rig, 30, 20)


class Reader:
    """What a viewer makes of a glTF file: nodes in the world, as the animation ends."""

    def __init__(self, whole: dict[str, Any], buffer: bytes) -> None:
        self.whole, self.buffer = whole, buffer

    @classmethod
    def of_text(cls, content: bytes) -> Reader:
        whole = json.loads(content)
        return cls(whole, base64.b64decode(whole["buffers"][0]["uri"].partition(",")[2]))

    def array(self, index: int) -> np.ndarray:
        accessor = self.whole["accessors"][index]
        view = self.whole["bufferViews"][accessor["bufferView"]]
        size = SIZES[accessor["type"]]
        values = np.frombuffer(
            self.buffer, "<f4", accessor["count"] * size, view["byteOffset"]
        ).reshape(-1, size)
        assert values.nbytes == view["byteLength"]
        return values

    def node(self, name: str) -> dict[str, Any]:
        (found,) = (node for node in self.whole["nodes"] if node["name"] == name)
        return dict(found)

    def room(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """The lowest and the highest corner of what a node shows, in its own frame."""
        pieces = self.whole["meshes"][self.node(name)["mesh"]]["primitives"]
        corners = np.vstack([self.array(piece["attributes"]["POSITION"]) for piece in pieces])
        return corners.min(axis=0), corners.max(axis=0)

    def keys(self, name: str, path: str) -> tuple[np.ndarray, np.ndarray]:
        (animation,) = self.whole["animations"]
        for channel in animation["channels"]:
            target = channel["target"]
            if target["path"] == path and self.whole["nodes"][target["node"]]["name"] == name:
                sampler = animation["samplers"][channel["sampler"]]
                return self.array(sampler["input"])[:, 0], self.array(sampler["output"])
        raise KeyError(name, path)

    def at_the_end(self) -> dict[str, np.ndarray]:
        nodes = [dict(node) for node in self.whole["nodes"]]
        (animation,) = self.whole["animations"]
        for channel in animation["channels"]:
            target, sampler = channel["target"], animation["samplers"][channel["sampler"]]
            nodes[target["node"]][target["path"]] = self.array(sampler["output"])[-1]
        found = {}

        def visit(index: int, above: np.ndarray) -> None:
            node = nodes[index]
            x, y, z, w = (float(v) for v in node.get("rotation", (0, 0, 0, 1)))
            here = np.eye(4)
            here[:3, :3] = np.array(matrix((w, x, y, z))).reshape(3, 3)
            here[:3, 3] = node.get("translation", (0, 0, 0))
            found[node["name"]] = above @ here
            for child in node.get("children", ()):
                visit(child, above @ here)

        (root,) = self.whole["scenes"][0]["nodes"]
        visit(root, np.eye(4))
        return found


@pytest.mark.parametrize("arm", ["minimover5", "teachmover"])
def test_the_animation_ends_where_the_arm_does(arm: str) -> None:
    rig, recording = recorded(arm)
    ends = Reader.of_text(gltf(rig, recording)).at_the_end()
    x, y, z, _ = ends["hand"] @ (rig.arm.model.hand_length * METRES, 0, 0, 1) / METRES
    # y is up in glTF, and what was forward stays so.
    assert (x, -z, y) == pytest.approx((rig.pose.x, rig.pose.y, rig.pose.z), abs=1e-4)
    disc = rig.arm.bench.parts["disc"].place
    x, y, z = ends["disc"][:3, 3] / METRES
    assert (x, -z, y) == pytest.approx(disc, abs=1e-4)


def test_times_grow_and_accessors_tell_their_bounds() -> None:
    reader = Reader.of_text(gltf(*recorded()))
    times, turns = reader.keys("upper_arm", "rotation")
    assert times[0] == 0
    assert (np.diff(times) > 0).all()
    assert np.linalg.norm(turns, axis=1) == pytest.approx(1, abs=1e-6)
    for index, accessor in enumerate(reader.whole["accessors"]):
        if "min" in accessor:
            values = reader.array(index)
            assert accessor["min"] == values.min(axis=0).tolist()
            assert accessor["max"] == values.max(axis=0).tolist()


def test_faces_look_outwards() -> None:
    reader = Reader.of_text(gltf(*recorded()))
    for piece in (piece for mesh in reader.whole["meshes"] for piece in mesh["primitives"]):
        attributes = piece["attributes"]
        corners = reader.array(attributes["POSITION"]).reshape(-1, 3, 3)
        ways = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 1])
        normals = reader.array(attributes["NORMAL"])[::3]
        assert (np.einsum("ij,ij->i", ways, normals) > 0).all()


@pytest.mark.parametrize("arm", ["minimover5", "teachmover"])
def test_no_link_is_seen_to_float(arm: str) -> None:
    rig, recording = recorded(arm)
    reader = Reader.of_text(gltf(rig, recording))
    links = ["turret", "upper_arm", "forearm", "wrist", "hand"]
    for before, link in pairwise(links):
        # The axis of the joint between them goes through both.
        place = np.array(reader.node(link).get("translation", (0, 0, 0)))
        for low, high, at in ((*reader.room(before), place), (*reader.room(link), np.zeros(3))):
            assert (low <= at + 1e-6).all(), (before, link)
            assert (high >= at - 1e-6).all(), (before, link)
    palm = reader.room("hand")[1][0] - rig.arm.model.hand_length * METRES
    for finger in ("left_finger", "right_finger"):
        assert reader.room(finger)[0][0] <= palm + 1e-6


def test_a_binary_file_is_the_same_in_chunks() -> None:
    rig, recording = recorded()
    content = glb(rig, recording)
    magic, version, length, text_length, kind = struct.unpack_from("<4sII I4s", content)
    assert (magic, version, length, kind) == (b"glTF", 2, len(content), b"JSON")
    whole = json.loads(content[20 : 20 + text_length])
    size, kind = struct.unpack_from("<I4s", content, 20 + text_length)
    assert kind == b"BIN\0"
    assert size == whole["buffers"][0]["byteLength"]
    text = Reader.of_text(gltf(rig, recording))
    assert content[28 + text_length :] == text.buffer
    assert whole["animations"] == text.whole["animations"]


def test_a_part_is_seen_only_while_it_is_there() -> None:
    rig, recording = recorded()
    block = rig.arm.bench.parts["disc"].shape
    still = recording.looks[0]
    looks = [
        Look(time, still.joints, still.motors, still.registers, parts)
        for time, parts in (
            (0.0, {}),
            (1.0, {0: ((1.0, 2.0, 3.0), STRAIGHT)}),
            (2.0, {0: ((1.0, 2.0, 4.0), STRAIGHT)}),
            (3.0, {}),
        )
    ]
    reader = Reader.of_text(gltf(rig, Recording(looks, [("blank 1", block)])))
    times, sizes = reader.keys("blank_1", "scale")
    assert times.tolist() == [0, 1, 3]
    assert sizes[:, 0].tolist() == [0, 1, 0]
    assert reader.keys("blank_1", "translation")[0].tolist() == [1, 2]


def test_a_run_is_recorded_until_a_moment_after_its_end() -> None:
    rig, recording = recorded()
    times = [look.time for look in recording.looks]
    last = recording.looks[-1].joints
    moving = [look.time for look in recording.looks if look.joints != last]
    assert times[-1] - moving[-1] == pytest.approx(LINGERS, abs=0.2)
    assert rig.outcome is not None


@pytest.mark.parametrize("seconds", [0.9 + k / 7_000_003 for k in range(20)])
def test_a_recording_ends_wherever_its_last_t_state_falls(seconds: float) -> None:
    rig = rig_of("minimover5", "")
    rig.load_text("10 @SET 20\n")
    looks = iter(record(rig, 30, seconds).looks)
    assert [look.time for look in looks][-1] == pytest.approx(seconds, abs=0.02)


def test_a_table_has_joints_motors_and_registers() -> None:
    rig, recording = recorded()
    rows = list(csv.reader(io.StringIO(csv_table(recording).decode("ascii"))))
    assert tuple(rows[0]) == COLUMNS
    first, last = (dict(zip(COLUMNS, map(float, row), strict=True)) for row in (rows[1], rows[-1]))
    assert [last[f"register_{n}"] for n in range(1, 7)] == list(rig.registers)
    moved = [last[f"J{n}"] - first[f"J{n}"] for n in range(1, 7)]
    assert moved == pytest.approx(rig.state.rotors, abs=1e-6)
    assert last["base"] == pytest.approx(rig.state.angles.base, abs=1e-11)
    assert last["left_finger"] == pytest.approx(rig.pose.opening / 2 * METRES, abs=1e-11)


def test_arrays_are_the_table() -> None:
    _, recording = recorded()
    arrays = np.load(io.BytesIO(npz_table(recording)))
    rows = np.loadtxt(io.BytesIO(csv_table(recording)), delimiter=",", skiprows=1)
    assert set(arrays) == set(COLUMNS)
    for place, name in enumerate(COLUMNS):
        assert np.abs(arrays[name] - rows[:, place]).max() < 1e-8
    assert len(JOINTS) == 7


@pytest.mark.parametrize("kind", ["gltf", "glb", "csv", "npz"])
def test_the_command_runs_a_program(kind: str, tmp_path: Path) -> None:
    program, bench = tmp_path / "p.bas", tmp_path / "p.toml"
    program.write_text("10 INPUT A\n20 @STEP 20,A,0,0,0,0,0\n", encoding="ascii")
    bench.write_text(BENCH, encoding="utf-8")
    target = tmp_path / f"run.{kind}"
    assert run(program, "-o", target, "--input", "50", "--seconds", "1.5", "--fps", "5") == (0, "")
    assert target.stat().st_size > 500


def test_a_cast_is_a_film_of_the_terminal(tmp_path: Path) -> None:
    program, target = tmp_path / "p.bas", tmp_path / "run.cast"
    program.write_text(PROGRAM, encoding="ascii")
    assert run(program, "-o", target, "--seconds", "0.1") == (0, "")
    header = json.loads(target.read_text(encoding="utf-8").splitlines()[0])
    assert (header["version"], header["title"][:5]) == (2, "p.bas")


def test_the_operator_answers(tmp_path: Path) -> None:
    program = tmp_path / "p.bas"
    program.write_text("10 INPUT A\n20 @STEP 20,A,0,0,0,0,0\n", encoding="ascii")
    table = tmp_path / "run.csv"
    assert run(program, "-o", table, "--input", "50") == (0, "")
    rows = list(csv.DictReader(table.read_text(encoding="ascii").splitlines()))
    assert rows[-1]["register_1"] == "50"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["-o", "{}/run.glb"], "name a program"),
        (["-o", "{}/run.cast"], "name a program"),
        (["{}/none.bas", "-o", "{}/run.csv"], "none.bas"),
        (["{}/none.bas", "-o", "{}/run.cast"], "none.bas"),
        (["table4", "-o", "{}/run.csv", "--set", "QQ:1"], "QQ:1"),
        (["table4", "-o", "{}/run.npz", "--memory-size", "A"], "MEMORY SIZE?"),
        (["table4", "-o", "{}/no/run.gltf", "--seconds", "0.1"], "No such file or directory"),
    ],
)
def test_a_run_that_cannot_be_is_told_in_one_line(
    words: list[str], said: str, tmp_path: Path
) -> None:
    assert said in refusal(words, tmp_path)
