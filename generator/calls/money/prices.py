"""Prices of models, read from a table that the user can edit."""

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
_MOST_BYTES = 2**20  # maximum size of a table
_MOST = 1e12  # maximum price
_SHIPPED = Path(__file__).with_name("prices.toml")


@dataclass(frozen=True)
class Price:
    """The prices of one model, in the table's currency.

    ``input`` and ``output`` are per million tokens, ``image`` per generated image, ``call`` per
    call. ``picture`` is not a price: it is the maximum number of tokens assumed for an input
    picture before a call is sent. The default exceeds the actual number for most models.

    Raises:
        InputError: a value is not a number of at least 0.
    """

    input: float = 0.0
    output: float = 0.0
    image: float = 0.0
    call: float = 0.0
    picture: float = 16_384.0

    def __post_init__(self) -> None:
        require(self, "input", "output", "image", "call", "picture", minimum=0)

    def of(self, tokens_in: int, tokens_out: int, images: int) -> float:
        """Return the cost of one call."""
        tokens = self.input * tokens_in + self.output * tokens_out
        return tokens / 1e6 + self.image * images + self.call

    def told(self, tokens_in: int, tokens_out: int) -> bool:
        """Return whether an answer reports the counts of all tokens that cost money."""
        return not (self.input and not tokens_in) and not (self.output and not tokens_out)


@dataclass(frozen=True)
class Prices:
    """Prices of models, their date and their currency."""

    date: str = ""
    currency: str = "USD"
    models: Mapping[str, Price] = dataclasses.field(default_factory=dict)

    def __reduce__(self) -> tuple[type[Prices], tuple[str, str, dict[str, Price]]]:
        """Support pickling; the internal lookup table cannot be pickled."""
        return Prices, (self.date, self.currency, dict(self.models))

    @classmethod
    def default(cls) -> Prices:
        """Return the example prices that are shipped with the package."""
        return cls.load(_SHIPPED)

    @classmethod
    def load(cls, path: str | Path) -> Prices:
        """Read a price table, such as ``prices.toml`` in this package.

        Raises:
            InputError: the file cannot be read, or an entry is not a valid price.
        """
        raw = read_regular(path, "The price table", InputError, max_bytes=_MOST_BYTES)
        table = parse_toml(raw, f"The price table {path}", InputError)
        known = [f.name for f in dataclasses.fields(cls)]
        for name in table:
            if name not in known:
                raise InputError(f"{path}: unknown setting {name!r}." + choices(name, known))
        models = table.get("models", {})
        if not isinstance(models, dict):
            raise InputError(f'{path}: models must be a table of entries [models."NAME"].')
        priced = {name: _price(f"{path}: {name}", entry) for name, entry in models.items()}
        date = printable(str(table.get("date", "")), f"{path}: the date", InputError)
        currency = printable(table.get("currency", "USD"), f"{path}: the currency", InputError)
        return cls(date, currency, MappingProxyType(priced))

    def price(self, model: str, server: str = "") -> Price | None:
        """Return a model's price at a server ("host:port"), or None if it is unknown.

        If the model's full name is not listed, the lookup tries the name without the provider
        before a slash ("openai/gpt-5") and without a date at the end, then the server:
        "@host:port", "@host".
        """
        bare = model.rpartition("/")[2]
        servers = (f"@{server}", f"@{_PORT.sub('', server)}")
        for name in (model, bare, _DATED.sub("", bare), *servers):
            if name in self.models:
                return self.models[name]
        return None


def unknown_price(what: str, budget: float, name: str = "MODEL") -> BudgetError:
    """Return the error for a call to ``name``, a model or "@host", with an unknown price."""
    return BudgetError(
        f"{what}: the price of the call is unknown, so the budget of {budget:g} cannot be "
        "enforced. Copy "
        f'the price table {_SHIPPED}, add [models."{name}"] with "input" and "output" '
        '(per million tokens), "image" or "call", and pass the copy with --prices FILE '
        "(Prices.load in Python); or remove the budget."
    )


def _price(where: str, entry: Any) -> Price:
    known = [f.name for f in dataclasses.fields(Price)]
    if not isinstance(entry, dict):
        raise InputError(
            f"{where}: a price must be a table with the keys {', '.join(known)}, got {entry!r:.80}."
        )
    for name, value in entry.items():
        if name not in known:
            raise InputError(f"{where}: unknown price {name!r}." + choices(name, known))
        require_number(f"{where}: {name}", value, minimum=0, maximum=_MOST)
    return Price(**{name: float(value) for name, value in entry.items()})
