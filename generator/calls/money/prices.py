"""What calls cost, by a table that the user can edit."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from ...errors import BudgetError, InputError, choices, require, require_number
from ...io.bounded import parse_toml, printable, read_regular

_DATED = re.compile(r"-(?:\d{4}-\d\d-\d\d|\d{6,8})$")
_PORT = re.compile(r":\d+$")
_MOST_BYTES = 2**20  # of a table
_MOST = 1e12  # of a price
_SHIPPED = Path(__file__).with_name("prices.toml")


@dataclass(frozen=True)
class Price:
    """What one model costs, in the table's currency.

    ``input`` and ``output`` are per million tokens, ``image`` per image answered, ``call`` per
    call. ``picture`` is no price, but the most tokens that a picture shown is taken to count for
    before a call is sent; the default is more than most take.

    Raises:
        InputError: one is no number from 0.
    """

    input: float = 0.0
    output: float = 0.0
    image: float = 0.0
    call: float = 0.0
    picture: float = 16_384.0

    def __post_init__(self) -> None:
        require(self, "input", "output", "image", "call", "picture", minimum=0)

    def of(self, tokens_in: int, tokens_out: int, images: int) -> float:
        """Return what one call costs."""
        tokens = self.input * tokens_in + self.output * tokens_out
        return tokens / 1e6 + self.image * images + self.call

    def told(self, tokens_in: int, tokens_out: int) -> bool:
        """Return whether an answer says how many tokens it took, of those that cost anything."""
        return not (self.input and not tokens_in) and not (self.output and not tokens_out)


@dataclass(frozen=True)
class Prices:
    """Prices of models, the day they were written down, and their currency."""

    date: str = ""
    currency: str = "USD"
    models: Mapping[str, Price] = dataclasses.field(default_factory=dict)

    def __reduce__(self) -> tuple[type[Prices], tuple[str, str, dict[str, Price]]]:
        """Let it be pickled, which what it looks prices up in cannot be."""
        return Prices, (self.date, self.currency, dict(self.models))

    @classmethod
    def default(cls) -> Prices:
        """Return the examples that come with the package."""
        return cls.load(_SHIPPED)

    @classmethod
    def load(cls, path: str | Path) -> Prices:
        """Read a table; ``prices.toml`` in this package is one.

        Raises:
            InputError: the file cannot be read, or says something that is not a price.
        """
        raw = read_regular(path, "The price table", InputError, max_bytes=_MOST_BYTES)
        table = parse_toml(raw, f"The price table {path}", InputError)
        known = [f.name for f in dataclasses.fields(cls)]
        for name in table:
            if name not in known:
                raise InputError(f"{path}: no setting {name!r}." + choices(name, known))
        models = table.get("models", {})
        if not isinstance(models, dict):
            raise InputError(f'{path}: models is a table of [models."name"].')
        priced = {name: _price(f"{path}: {name}", entry) for name, entry in models.items()}
        date = printable(str(table.get("date", "")), f"{path}: the date", InputError)
        currency = printable(table.get("currency", "USD"), f"{path}: the currency", InputError)
        return cls(date, currency, MappingProxyType(priced))

    def price(self, model: str, server: str = "") -> Price | None:
        """Return a model's price at a server ("host:port"), or None if it is not known.

        A model that is not listed as it is, is looked for without the provider before a slash
        ("openai/gpt-5") and without the date at its end, then its server: "@host:port", "@host".
        """
        bare = model.rpartition("/")[2]
        servers = (f"@{server}", f"@{_PORT.sub('', server)}")
        for name in (model, bare, _DATED.sub("", bare), *servers):
            if name in self.models:
                return self.models[name]
        return None


def unknown_price(what: str, budget: float, name: str = "MODEL") -> BudgetError:
    """Return the error of a call to ``name``, a model or "@host", whose price is not known."""
    return BudgetError(
        f"{what}: its price is not known, so the budget of {budget:g} cannot be kept. Copy "
        f'the price table {_SHIPPED}, add [models."{name}"] with "input" and "output" (per '
        'million tokens), "image" or "call", and name the copy by --prices FILE (Prices.load in '
        "Python); or give no budget."
    )


def _price(where: str, entry: Any) -> Price:
    known = [f.name for f in dataclasses.fields(Price)]
    if not isinstance(entry, dict):
        raise InputError(f"{where}: a price is a table of {', '.join(known)}, got {entry!r:.80}.")
    for name, value in entry.items():
        if name not in known:
            raise InputError(f"{where}: no price {name!r}." + choices(name, known))
        require_number(f"{where} needs {name}", value, minimum=0, maximum=_MOST)
    return Price(**{name: float(value) for name, value in entry.items()})
