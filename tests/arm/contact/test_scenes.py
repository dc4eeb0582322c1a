"""Scenes of `scenes/`, played to their end; the ends stand there as text."""

from __future__ import annotations

import pytest

from tests.arm.contact.laying import Story, differences, ends, played, stories

STORIES = stories()


def test_there_are_scenes_of_every_sort() -> None:
    assert len(STORIES) >= 55
    assert len({story.name for story in STORIES}) == len(STORIES)


@pytest.mark.parametrize("story", STORIES, ids=lambda story: story.name)
def test_a_scene_ends_as_it_should(story: Story) -> None:
    assert differences(story, ends(played(story)), story.ends) == []
