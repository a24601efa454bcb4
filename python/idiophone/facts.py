"""Facts: named values in groups."""
from __future__ import annotations

from typing import Any


class Facts(dict[str, Any]):
    """A dict whose values are attributes, too: `facts.costs.memory_bytes` is `facts["costs"]["memory_bytes"]`."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name}; there are: {', '.join(map(str, self))}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *map(str, self)]
