"""The drawing as SVG: a whole XML file, every part in it, and a slipped arm beside its ghost."""

from __future__ import annotations

from xml.etree import ElementTree

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.vectors import COLOURS, svg
from trs80arm.rig import Rig

SVG = "{http://www.w3.org/2000/svg}"


def drawn(rig: Rig) -> ElementTree.Element:
    return ElementTree.fromstring(svg(Readings.of(rig)))


def test_a_part_is_seen_from_the_side_and_from_above() -> None:
    side, above = drawn(Rig()).findall(f"{SVG}g")
    for view in (side, above):
        parts = [
            each for each in view.iter(f"{SVG}polygon") if each.get("stroke") == COLOURS[Ink.PART]
        ]
        assert len(parts) == 1


def test_a_slipped_arm_is_drawn_beside_where_it_was_told_to_be() -> None:
    rig = Rig()
    rig.type("@STEP 5,0,0,400\r")
    rig.run_until_waiting()
    assert rig.registers != rig.joints
    side, _ = drawn(rig).findall(f"{SVG}g")
    ghost = [each for each in side.iter(f"{SVG}line") if each.get("stroke-dasharray")]
    assert ghost
    texts = [text.text or "" for text in drawn(rig).findall(f"{SVG}text")]
    assert texts[3].split() == ["elbow", "400", str(rig.joints[2])]
