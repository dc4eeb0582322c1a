"""Component styles that are found when they are asked for.

Textual finds the styles of all component classes of a widget whenever its styles are updated, twice
before the first frame. A panel has an ink in two dozen of them and uses few: here each is found at
its first use. The private hooks that this leans on are pinned by `tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

from textual.css.styles import RenderStyles
from textual.dom import DOMNode
from textual.widget import Widget


class LateComponents(Widget):
    """A widget whose components need not stand in `COMPONENT_CLASSES`."""

    def get_component_styles(self, *names: str) -> RenderStyles:
        """The styles of components, whatever they are called."""
        for name in names:
            if name not in self._component_styles:
                component = DOMNode(classes=name)
                component._attach(self)
                self.app.stylesheet.apply(component, animate=False)
                self._component_styles[name] = component.styles
        return super().get_component_styles(*names)

    def notify_style_update(self) -> None:
        """The style sheet changed, or what of it holds here: all is to be found anew."""
        self._component_styles.clear()
        self.refresh()
        super().notify_style_update()
