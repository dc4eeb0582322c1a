"""The input nibble behind a selector: banks of sensors, shown by bits of the auxiliary output."""

from __future__ import annotations

import pytest

from tests.arm.cell.cells import arm_at, at_the_cell
from tests.arm.refusals import refusal
from trs80arm.arm import Pose

AUXILIARY = 6

BANKS = """
[selector]
bits = [2, 3]
[[proximity]]
name = "near"
at = [8, 0, 0]
range = 1.0
bit = 1
bank = 2
[[tactile]]
name = "pad"
at = [8, 0]
size = [1, 1]
bit = 1
bank = 3
[[beam]]
name = "beam"
from = [8, -2, 0.5]
to = [8, 2, 0.5]
bit = 3
[[part]]
at = [8, 0]
size = [0.5, 0.5, 1]
"""
"""Three sensors, all of which the part has answer."""


def test_a_sensor_is_seen_only_while_the_selector_shows_its_bank() -> None:
    arm = arm_at(BANKS)
    seen = {}
    for output in range(16):
        arm.apply([output], [AUXILIARY], [output])
        seen[output] = arm.inputs(output)
    assert {output >> 2: bits for output, bits in seen.items()} == {
        0: 0b0111,
        1: 0b1111,
        2: 0b1101,
        3: 0b1101,
    }
    assert all(seen[output] == seen[output & 0b1100] for output in range(16))


def test_the_grip_switch_is_on_bit_0_in_every_bank() -> None:
    arm = arm_at(BANKS)
    arm.grip.contact = arm.grip.cable + 10
    for output in (0, 4, 8, 12):
        arm.apply([output], [AUXILIARY], [output])
        assert arm.inputs(output) & 1 == 0


def test_the_bits_are_wired_in_the_order_in_which_they_are_named() -> None:
    text = BANKS.replace("[2, 3]", "[3, 0]")
    arm = arm_at(text)
    arm.apply([0], [AUXILIARY], [0b0001])
    assert arm.inputs(0) == 0b1101
    arm.apply([1], [AUXILIARY], [0b1000])
    assert arm.inputs(1) == 0b1111


def test_out_selects_and_inp_reads() -> None:
    rig = at_the_cell(BANKS)
    rig.type("FOR I=0 TO 12 STEP 4:OUT 158,I:?INP(152) AND 15;:NEXT\r")
    rig.run_until_waiting()
    assert " 7  15  13  13" in rig.screen()


def test_each_sensor_says_what_it_senses_whatever_the_selector_shows() -> None:
    rig = at_the_cell(BANKS)
    said = {name: (answer.bit, answer.bank, answer.given) for name, answer in rig.sensors.items()}
    assert said == {"near": (1, 2, True), "pad": (1, 3, True), "beam": (3, 0, True)}
    (part,) = rig.arm.bench.parts
    rig.arm.bench.scene.remove(part)
    assert not any(answer.given for answer in rig.sensors.values())


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[selector]", "selector.bits: expected 1 to 4 different bits of the auxiliary output"),
        ("[selector]\nbits=[1,1]", "selector.bits: expected 1 to 4 different bits"),
        ("[selector]\nbits=[4]", "selector.bits: expected 1 to 4 different bits"),
        ("[selector]\nbits=[true]", "selector.bits: expected 1 to 4 different bits"),
        ("[selector]\nbits=[0]\nbit=1", "selector.bit: expected nothing by that name"),
        (
            "[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=1\nbank=1",
            "tactile[1].bank: expected a [selector] in the file, whose bits choose a bank",
        ),
        (
            "[selector]\nbits=[0]\n[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=1\nbank=2",
            "tactile[1].bank: expected a whole number from 0 to 1",
        ),
        (
            "[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=1\n[[beam]]\nfrom=[0,0,0]\nto=[1,1,1]\nbit=1",
            "beam[1].bit: expected an input bit that no other sensor uses",
        ),
        (
            "[selector]\nbits=[0]\n" + "[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=1\nbank=1\n" * 2,
            "tactile[2].bit: expected an input bit and bank that no other sensor uses",
        ),
        (
            "[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=1\nname='a'\n"
            "[[tactile]]\nat=[8,0]\nsize=[1,1]\nbit=2\nname='a'",
            "tactile[2].name: expected a name that no other sensor has",
        ),
    ],
)
def test_a_selector_or_bank_that_cannot_be_gets_one_line(text: str, line: str) -> None:
    assert refusal(text).startswith(f"b.toml: {line}")


def test_without_a_selector_the_auxiliary_output_changes_nothing() -> None:
    text = BANKS.replace("[selector]\nbits = [2, 3]", "")
    text = (
        text.replace("bank = 2", "")
        .replace("bank = 3", "")
        .replace("size = [1, 1]\nbit = 1", "size = [1, 1]\nbit = 2")
    )
    arm = arm_at(text)
    for output in range(16):
        arm.apply([output], [AUXILIARY], [output])
        assert arm.inputs(output) == 0b0001
    arm.bench.scene.clear()
    arm.move_to(Pose(6, 4, 3, -90, 0))
    assert arm.inputs(20) == 0b1111
