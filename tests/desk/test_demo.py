"""The demonstration plays the article's task."""

from __future__ import annotations

from trs80arm.desk.demo import SCENES, Demo
from trs80arm.desk.session import Session


def test_it_picks_up_a_part_and_puts_it_down() -> None:
    session = Session()
    demo = Demo(session)
    captions: list[str] = []
    held: list[bool] = []
    while demo.caption != SCENES[-1].caption:
        demo.go_on()
        if not captions or captions[-1] != demo.caption:
            captions.append(demo.caption)
        now = session.rig.state.held is not None
        if not held or held[-1] is not now:
            held.append(now)
        session.run_for(0.1)
        assert session.time < 240
    assert captions == [scene.caption for scene in SCENES]
    assert held[:3] == [False, True, False]


def test_every_caption_fits_into_the_status_line() -> None:
    assert max(len(scene.caption) for scene in SCENES) < 76
