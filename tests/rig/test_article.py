"""The article's figures, from arm, card and keys as they are set."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from tests.goldens import check_golden
from trs80arm.arm.figures import Diagram, FigureError
from trs80arm.arm.settings import ArmSettings
from trs80arm.article import NAMES, draw
from trs80arm.cli.commands import cli
from trs80arm.machine.card import CardSettings, Jumper, Latch
from trs80arm.machine.driver import DriverSettings
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.keys import Key
from trs80arm.rig import RigSettings

DOCS = Path(__file__).parents[2] / "docs"
DIAGRAMS = ("1", "3", "4", "5", "7", "9", "11")
TEACHMOVER = RigSettings(arm=ArmSettings(model="teachmover"))


def diagram(name: str, settings: RigSettings | None = None) -> Diagram:
    (part,) = draw(name, settings).parts
    assert isinstance(part, Diagram)
    return part


def drawn_words(svg: str) -> list[str]:
    """The words of a drawing."""
    return [
        "".join(element.itertext())
        for element in ElementTree.fromstring(svg.encode()).iter()
        if element.tag.endswith("}text")
    ]


@pytest.mark.parametrize("name", DIAGRAMS)
def test_diagrams_as_text(name: str) -> None:
    check_golden(f"figure-{name}", draw(name).text())


@pytest.mark.parametrize("name", ["1", "3", "4", "5", "9", "11"])
def test_diagrams_of_the_teachmover_as_text(name: str) -> None:
    check_golden(f"figure-{name}-teachmover", draw(name, TEACHMOVER).text())


@pytest.mark.parametrize("name", DIAGRAMS)
@pytest.mark.parametrize("settings", [RigSettings(), TEACHMOVER])
def test_a_diagram_is_plain_and_not_wider_than_a_terminal(name: str, settings: RigSettings) -> None:
    for line in diagram(name, settings).lines:
        assert line.isascii()
        assert len(line) <= 79
        assert line == line.rstrip()


@pytest.mark.parametrize("name", DIAGRAMS)
def test_a_drawing_is_one_file_with_its_words_in_it_light_and_dark(
    name: str, tmp_path: Path
) -> None:
    path = tmp_path / "figure.svg"
    draw(name).save(path)
    svg = path.read_text(encoding="utf-8")
    root = ElementTree.fromstring(svg.encode())
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    assert "prefers-color-scheme:dark" in svg
    assert "href" not in svg
    assert len(drawn_words(svg)) > 5
    # Everything stands on the sheet.
    width, height = (float(root.attrib[name]) for name in ("width", "height"))
    for element in root.iter():
        for pair in element.attrib.get("points", "").split():
            x, y = map(float, pair.split(","))
            assert 0 <= x <= width
            assert 0 <= y <= height


@pytest.mark.parametrize("name", DIAGRAMS)
def test_the_page_of_the_figures_shows_what_the_program_draws(name: str) -> None:
    drawn = draw(name)
    page = (DOCS / "figures.md").read_text(encoding="utf-8")
    assert f"![{drawn.title}](figures/{name}.svg)" in page
    shown = (DOCS / "figures" / f"{name}.svg").read_text(encoding="utf-8")
    assert shown == diagram(name).sheet.svg(drawn.title)


def test_a_diagram_is_saved_as_a_picture_too(tmp_path: Path) -> None:
    draw("7").save(tmp_path / "7.png")
    assert (tmp_path / "7.png").read_bytes().startswith(b"\x89PNG")


def test_lengths_ranges_and_ratios_are_the_arms() -> None:
    assert "H = 8.1 in" in drawn_words(diagram("1").sheet.svg(""))
    assert "H = 7.625 in" in drawn_words(diagram("1", TEACHMOVER).sheet.svg(""))
    text = "\n".join(diagram("3", TEACHMOVER).lines)
    assert "J4 right wrist" in text
    assert "a program has to take back as many of J6" in text
    assert "32 half-steps to the pound" in "\n".join(diagram("5", TEACHMOVER).lines)
    assert "J5: P + R" in "\n".join(diagram("4", TEACHMOVER).lines)


def test_the_block_diagram_is_of_the_card_as_it_is_set() -> None:
    order = (*reversed(Latch), None)
    card = CardSettings(base=0x40, order=order, switch_bit=2, switch_closed=1)
    text = "\n".join(diagram("9", RigSettings(card=card)).lines)
    assert "ports 40H to 47H" in text
    assert "[latch 46H] => 4 drivers => J1 base" in text
    assert "bit 2: grip switch, 1 = closed" in text
    assert "bits 0, 1, 3: free" in text
    parallel = CardSettings(jumper=Jumper.PARALLEL)
    assert "D4 to D7" in "\n".join(diagram("9", RigSettings(card=parallel)).lines)


def test_the_drive_circuit_has_each_coil_at_its_bit() -> None:
    card = CardSettings(coil_bits=(0, 1, 2, 3))
    words = drawn_words(diagram("7", RigSettings(card=card)).sheet.svg(""))
    assert [word for word in words if word in ("D0", "D1", "D2", "D3")] == ["D0", "D1", "D2", "D3"]


def test_the_keyboard_is_of_the_keys_as_they_are_set() -> None:
    keys = JogKeys(
        positive=(Key.A, Key.S, Key.D, Key.F, Key.G, Key.H),
        negative=(Key.Z, Key.X, Key.C, Key.V, Key.B, Key.N),
        leave=Key.ENTER,
    )
    lines = diagram("11", RigSettings(driver=DriverSettings(keys=keys))).lines
    row = next(number for number, line in enumerate(lines) if "| A " in line)
    assert "|+J1 |" in lines[row + 1]
    assert "ENTER ends manual mode" in lines[-1]


def test_what_the_article_lists_is_not_of_another_arm() -> None:
    for name in ("12", "table1"):
        with pytest.raises(FigureError, match="MiniMover 5's own"):
            draw(name, TEACHMOVER)


def test_the_command_line_draws_the_arm_that_is_asked_for() -> None:
    done = CliRunner().invoke(cli, ["figure", "1", "--arm", "teachmover"])
    assert done.exit_code == 0
    assert "3.8 in" in done.stdout
    refused = CliRunner().invoke(cli, ["figure", "1", "--arm", "robot"])
    assert (refused.exit_code, refused.stderr.count("\n")) == (2, 1)
    unknown = CliRunner().invoke(cli, ["figure", "99"])
    assert ", ".join(NAMES) in unknown.stderr
