"""The same scenes before MuJoCo: it has the same parts end in the same places."""

from __future__ import annotations

import pytest

from tests.arm.contact.laying import Story, differences, stories
from tests.arm.contact.referee import judged


@pytest.mark.parametrize("story", stories(), ids=lambda story: story.name)
def test_the_referee_has_a_scene_end_so_too(story: Story) -> None:
    assert differences(story, judged(story), story.referee) == []
