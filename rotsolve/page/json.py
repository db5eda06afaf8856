"""JSON: what a page holds for programs."""

from __future__ import annotations

import json
from collections.abc import Sequence

from rotsolve.page.blocks import Page
from rotsolve.page.printer import Printer


class Json(Printer):
    """The data of pages."""

    def body(self, page: Page, width: int) -> str:
        return json.dumps(page.data(), ensure_ascii=False, indent=2) + "\n"

    def document(self, bodies: Sequence[str]) -> str:
        """One object alone, several as an array."""
        if len(bodies) == 1:
            return bodies[0]
        return "[\n" + ",\n".join(item.rstrip("\n") for item in bodies) + "\n]\n"


PRINTER = Json()
