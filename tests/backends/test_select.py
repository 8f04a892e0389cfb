import json
import pickle
from dataclasses import dataclass, field

import pytest

from generator.backends import Backends, Mix, select
from generator.backends.embedded.imager import EmbeddedImager as EmbeddedImager
from generator.backends.protocols import in_turn
from generator.calls import Session
from generator.errors import BackendError


@dataclass(frozen=True)
class MyModeler:
    revision: str = "r1"

    def model(self, instance, size, view):
        raise AssertionError


def test_embedded_answers_every_question() -> None:
    backends = Backends.select("embedded")
    assert set(backends.identity()) == {"reasoner", "imager", "segmenter", "modeler", "encoder"}


@pytest.mark.parametrize("name", ["embedded"])
def test_a_backend_is_recorded_by_its_name_and_role_whatever_module_it_is_in(name: str) -> None:
    told = Backends.select(name).identity()
    assert {role: entry["class"] for role, entry in told.items()} == {
        role: f"{name}.{role}" for role in told
    }


def test_your_own_class_takes_one_role() -> None:
    backends = Backends.select("embedded", modeler=MyModeler())
    assert backends.identity()["modeler"]["revision"] == "r1"
    assert isinstance(backends.modeler, MyModeler)


@dataclass(frozen=True)
class Composed(MyModeler):
    sizes: tuple[int, ...] = (2, 3)
    rest: MyModeler | None = None
    table: dict[str, int] = field(default_factory=dict)


def test_tuples_and_backends_within_are_recorded_and_what_cannot_be_written_is_left_out() -> None:
    told = Backends.select("embedded", modeler=Composed(rest=MyModeler("r2"))).identity()["modeler"]
    assert told["sizes"] == [2, 3]
    assert (told["rest"]["class"], told["rest"]["revision"]) == (f"{__name__}.MyModeler", "r2")
    assert "table" not in told
    assert json.loads(json.dumps(told)) == told


def test_names_and_roles_are_checked() -> None:
    with pytest.raises(BackendError, match="Did you mean 'embedded'"):
        Backends.select("embeded")
    with pytest.raises(BackendError, match="Did you mean 'modeler'"):
        Backends.select("embedded", modeller=MyModeler())


def test_an_object_without_the_methods_is_refused() -> None:
    with pytest.raises(BackendError, match="lacks draw, complete, top_view"):
        Backends.select("embedded", imager=MyModeler())


def test_a_name_is_looked_for_among_those_that_have_the_role() -> None:
    with pytest.raises(BackendError) as told:
        Backends.select("embedded", modeler="hunyuan3")
    assert "Unknown modeler 'hunyuan3'. Did you mean 'hunyuan3d'?" in str(told.value)
    assert "huggingface" not in str(told.value)


def test_questions_that_nobody_answers_are_named_all_at_once_before_anything_loads(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(select, "_load", lambda *_: pytest.fail("it loads"))
    with pytest.raises(BackendError) as told:
        Backends.select("cloud", encoder="hunyuan3d", modeler=MyModeler())
    assert "'cloud' has no segmenter (segment)." in str(told.value)
    assert "'hunyuan3d' has no encoder (features)." in str(told.value)
    assert "Available: embedded, huggingface." in str(told.value)
    assert "modeler" not in str(told.value)


def test_a_mix_of_names_is_what_select_makes_of_them() -> None:
    mix = Mix(segmenter="huggingface", modeler="hunyuan3d", imager="embedded")
    session = Session()
    mixed = mix.select(session)
    plain = Backends.select(segmenter="huggingface", modeler="hunyuan3d", session=session)
    assert mixed.identity() == plain.identity()
    assert getattr(mixed.modeler, "session") is session  # noqa: B009
    assert mixed.asks_servers() and not Mix().select().asks_servers()
    assert mix.identity() == {
        "backend": "embedded", "roles": {"segmenter": "huggingface", "modeler": "hunyuan3d"}
    }  # fmt: skip
    assert Mix(modeler="embedded").identity() == Mix().identity() == {"backend": "embedded"}
    assert Mix(backend=None, modeler="folder").roles()["imager"] == "embedded"
    assert pickle.loads(pickle.dumps(mix)) == mix
    assert Mix().given and Mix(backend=None, encoder="embedded").given
    assert not Mix(backend=None).given


@dataclass(frozen=True)
class Remote(MyModeler):
    session: Session = field(default_factory=Session, repr=False, compare=False)


def test_what_asks_servers_shares_the_session(monkeypatch: pytest.MonkeyPatch) -> None:
    entry = {"remote": {"modeler": f"{__name__}:Remote"}}
    monkeypatch.setattr(select, "TABLE", {**select.TABLE, **entry})
    session = Session(workers=2)
    backends = Backends.select("embedded", modeler="remote", session=session)
    assert isinstance(backends.modeler, Remote) and backends.modeler.session is session
    assert backends.each("modeler") == session.each
    assert "session" not in backends.identity()["modeler"]
    own = Backends.select("embedded", modeler=Remote(), session=session)
    assert isinstance(own.modeler, Remote) and own.modeler.session is not session


def test_what_computes_here_is_asked_in_turn() -> None:
    backends = Backends.select("embedded", session=Session())
    assert [backends.each(role) for role in backends.identity()] == [in_turn] * 5


def test_the_cloud_imager_gets_the_embedded_one_to_fall_back_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "a-key")
    by_name = Backends.select("embedded", imager="cloud").imager
    given = Backends.select("embedded", imager=type(by_name)()).imager
    assert all(type(imager.fallback) is EmbeddedImager for imager in (by_name, given))
