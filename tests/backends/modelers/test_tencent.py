"""Tencent's cloud jobs: submitted, looked at, downloaded; never paid for twice."""

import base64
import copy
import dataclasses
import io
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import httpx2
import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import edited, glb, instance, prior, striped_box
from backends.modelers.server import Answer, Call, quick, serving
from PIL import Image

from generator.backends.modelers.ai3d import Service, authorization
from generator.backends.modelers.tencent import HOSTS, Tencent
from generator.calls.money.prices import Price, Prices
from generator.calls.question import question
from generator.calls.session import Session
from generator.calls.store import KEY as KEPT
from generator.calls.store import CallStore, Used
from generator.errors import BackendError, InputError
from generator.scene import USUAL_VIEW, Model

GOOD = glb(striped_box((1.0, 2.0, 1.0)))
ID, KEY = "AKIDexampleexample", "secret-of-the-tests"
SUBMIT, QUERY, LOAD = "SubmitHunyuanTo3DProJob", "QueryHunyuanTo3DProJob", "download"


@pytest.fixture(autouse=True)
def keys(monkeypatch):
    monkeypatch.setenv("TENCENTCLOUD_SECRET_ID", ID)
    monkeypatch.setenv("TENCENTCLOUD_SECRET_KEY", KEY)


@dataclass
class Cloud:
    """Jobs go through ``states``; ``loads`` are the answers to downloads, the last one repeated.

    ``errors`` are the codes with which calls of an action are refused, in turn.
    """

    states: list[dict] = field(
        default_factory=lambda: [{"Status": "WAIT"}, {"Status": "RUN"}, {"Status": "DONE"}]
    )
    loads: list[Answer] = field(default_factory=lambda: [Answer(body=GOOD)])
    errors: dict[str, list[str]] = field(default_factory=dict)
    place: str = ""
    jobs: int = 0
    looks: dict[str, int] = field(default_factory=dict)
    log: list[str] = field(default_factory=list)

    def __call__(self, call: Call) -> Answer:
        if call.method == "GET":
            self.log.append(LOAD)
            return self.loads[min(self.log.count(LOAD), len(self.loads)) - 1]
        action = call.headers["x-tc-action"]
        self.log.append(action)
        if self.errors.get(action):
            code = self.errors[action].pop(0)
            return told(Error={"Code": code, "Message": f"about {KEY} and so on"})
        if refusal := self.checked(call, action):
            return told(Error={"Code": "AuthFailure.SignatureFailure", "Message": refusal})
        if action == SUBMIT:
            self.jobs += 1
            return told(JobId=f"job-{self.jobs}")
        job = call.json["JobId"]
        state = self.states[min(self.looks.get(job, 0), len(self.states) - 1)]
        self.looks[job] = self.looks.get(job, 0) + 1
        host = call.headers["host"]
        url = self.place or f"http://{host}/{job}.glb?q-sign-time={time.monotonic_ns()}"
        files = [{"Type": "OBJ", "Url": url + "zip"}, {"Type": "GLB", "Url": url}]
        return told(**state, **({"ResultFile3Ds": files} if state["Status"] == "DONE" else {}))

    def checked(self, call: Call, action: str) -> str:
        """Return the errors in a call's signature, as the service would check it."""
        stamp = int(call.headers["x-tc-timestamp"])
        if abs(time.time() - stamp) > 300:
            return "expired"
        host = call.headers["host"]
        wanted = authorization(ID, KEY, host=host, action=action, body=call.body, timestamp=stamp)
        return "" if call.headers["authorization"] == wanted else "signature"


def told(**response: object) -> Answer:
    return Answer.of({"Response": {**response, "RequestId": "f0c1"}})


def ask(url: str, session: Session | None = None, **settings) -> Model:
    settings = {"interval": 0.01, "hosts": ("127.0.0.1",), **settings}
    made = Tencent(url, session=session or quick(), **settings)
    return made.model(instance("mug"), prior("mug"), USUAL_VIEW)


def refused(cloud: Callable[[Call], Answer], session: Session | None = None, **settings) -> str:
    with serving(cloud) as served, pytest.raises(BackendError) as caught:
        ask(served.url, session, **settings)
    assert str(caught.value).startswith("tencent, model")
    assert KEY not in str(caught.value)
    return str(caught.value)


def test_a_job_is_submitted_looked_at_and_downloaded():
    cloud = Cloud()
    with serving(cloud) as served:
        made = ask(served.url)
    assert cloud.log == [SUBMIT, QUERY, QUERY, QUERY, LOAD]
    np.testing.assert_allclose(made.size / made.size[0], [1, 1, 2], rtol=1e-5)
    body = served.calls[0].json
    assert set(body) == {"ImageBase64", "GenerateType", "EnablePBR", "FaceCount"}
    picture = Image.open(io.BytesIO(base64.b64decode(body["ImageBase64"], validate=True)))
    assert picture.mode == "RGBA" and min(picture.size) >= 128
    assert served.calls[0].headers["x-tc-version"] == "2025-05-13"
    assert served.calls[0].headers["x-tc-region"] == "ap-guangzhou"


def test_downloads_get_no_key():
    with serving(Cloud()) as served:
        ask(served.url)
    load = next(call for call in served.calls if call.method == "GET")
    assert "authorization" not in load.headers
    assert KEY not in str(served.calls)


DAMAGED = Answer(body=GOOD[:100])
EXPIRED = Answer(403, b"<Error/>", "application/xml")
PAGE = Answer(body=b"<html>Log in</html>", kind="text/html")
SQUARE = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 3, 2]])
GONE, FAILED = "ResourceNotFound.JobNotExist", {QUERY: ["InternalError"]}
MENDED = {"loads": [Answer(body=GOOD)]}


@pytest.mark.parametrize(
    ("first", "told", "then", "jobs", "log"),
    [
        ({"errors": FAILED}, "InternalError", {}, 1, [QUERY] * 3 + [LOAD]),
        ({"errors": FAILED}, "InternalError", {"errors": {QUERY: [GONE]}}, 2, None),
        ({"loads": [EXPIRED]}, "cannot be downloaded", {"loads": [EXPIRED, Answer(body=GOOD)]}, 1,
         [LOAD, QUERY, LOAD]),
        ({"loads": [Answer(body=glb(SQUARE))]}, "tencent, model", MENDED, 2, None),
        ({"loads": [PAGE]}, "HTML page", MENDED, 1, None),
    ],
    ids=["killed", "kept no longer", "expired address", "no model can be made", "page"],
)  # fmt: skip
def test_the_next_run_pays_again_only_where_the_job_is_of_no_use(
    first, told, then, jobs, log, tmp_path
):
    cloud = Cloud(**copy.deepcopy(first))
    with serving(cloud) as served:
        with pytest.raises(BackendError, match=told):
            ask(served.url, quick(CallStore(tmp_path)))
        vars(cloud).update(copy.deepcopy(then), log=[])
        assert ask(served.url, quick(CallStore(tmp_path))).name == "mug_1"
    assert cloud.jobs == jobs
    assert log is None or cloud.log == log


def test_a_job_that_is_never_there_is_told():
    assert "JobNotExist" in refused(Cloud(errors={QUERY: [GONE] * 9}))


def test_what_is_done_needs_no_network_again(tmp_path):
    cloud = Cloud()
    with serving(cloud) as served:
        ask(served.url, quick(CallStore(tmp_path)))
        calls = len(cloud.log)
        ask(served.url, quick(CallStore(tmp_path)))
    assert len(cloud.log) == calls


def test_a_job_that_fails_is_told_and_submitted_anew_by_the_next_run(tmp_path):
    failing = {"Status": "FAIL", "ErrorCode": "FailedOperation", "ErrorMessage": "no object"}
    cloud = Cloud([{"Status": "RUN"}, failing])
    said = refused(cloud, quick(CallStore(tmp_path)))
    assert "job job-1 ended as 'FAIL' (FailedOperation no object)" in said
    assert cloud.jobs == 1
    with serving(cloud) as served:
        cloud.states = [{"Status": "RUN"}, failing]
        session = quick(CallStore(tmp_path / "other"))
        with pytest.raises(BackendError):
            ask(served.url, session)
        cloud.states = [{"Status": "RUN"}, {"Status": "DONE"}]
        assert ask(served.url, session).name == "mug_1"
    assert cloud.jobs == 3


def test_a_damaged_download_is_fetched_once_more(tmp_path):
    cloud = Cloud(loads=[DAMAGED, Answer(body=GOOD)])
    with serving(cloud) as served:
        for _ in range(2):
            assert ask(served.url, quick(CallStore(tmp_path))).name == "mug_1"
    assert (cloud.jobs, cloud.log.count(LOAD)) == (1, 2)
    assert "the answer is truncated" in refused(Cloud(loads=[DAMAGED]))


def test_a_compressed_download_is_fetched_once():
    def compress(header: dict) -> None:
        header["extensionsUsed"] = header["extensionsRequired"] = ["KHR_mesh_quantization"]

    cloud = Cloud(loads=[Answer(body=edited(GOOD, compress))])
    with serving(cloud) as served:
        assert ask(served.url).name == "mug_1"
    assert cloud.log.count(LOAD) == 1


def test_each_attempt_is_signed_as_of_its_own_time(monkeypatch):
    """A signature is valid for five minutes, which is less than some retry delays."""
    now, cloud, stamps = [1_800_000_000.0], Cloud(), []
    monkeypatch.setattr(time, "time", lambda: now[0])

    def busy(call: Call) -> Answer:
        if not stamps:
            now[0] += 400
        stamps.append(call.headers.get("x-tc-timestamp"))
        return Answer(503, b"later", "text/plain") if len(stamps) == 1 else cloud(call)

    with serving(busy) as served:
        assert ask(served.url, quick(attempts=2)).name == "mug_1"
    assert stamps[:2] == ["1800000000", "1800000400"]


def test_a_clock_that_is_wrong_is_no_wrong_key():
    said = refused(Cloud(errors={SUBMIT: ["AuthFailure.SignatureExpire"]}))
    assert "clock" in said and "Check TENCENT" not in said


@pytest.mark.slow
def test_a_busy_service_is_waited_for():
    cloud = Cloud(errors={SUBMIT: ["RequestLimitExceeded.JobNumExceed", "RequestLimitExceeded"]})
    with serving(cloud) as served:
        assert ask(served.url).name == "mug_1"
    assert cloud.jobs == 1
    assert "RequestLimitExceeded" in refused(
        Cloud(errors={SUBMIT: ["RequestLimitExceeded"] * 999}), timeout=0.1
    )


def test_a_job_that_takes_too_long_is_left_to_go_on():
    said = refused(Cloud([{"Status": "RUN"}]), timeout=0.1)
    assert "job job-1 is not done after 0.1 s. The job continues" in said


@pytest.mark.parametrize(
    "place",
    [
        "https://evil.example.org/a.glb",
        "https://eviltencentcos.cn/a.glb",
        "http://bucket.cos.ap-guangzhou.tencentcos.cn/a.glb",
        "https://127.0.0.1.evil.org/a.glb",
    ],
)
def test_results_elsewhere_are_not_fetched(place):
    cloud = Cloud(place=place)
    said = refused(cloud, hosts=(*HOSTS, "127.0.0.1"))
    assert "the result is at" in said and "add it to Tencent.hosts" in said
    assert LOAD not in cloud.log


@pytest.mark.slow
@pytest.mark.parametrize(
    "place",
    ["file:///etc/passwd", "http://[::1", "https://a\u2100b/x", "https://a.tencentcos.cn:0/x",
     "https://user:pass@a.tencentcos.cn/x", "//", "https://" + "a" * 9000],
)  # fmt: skip
def test_what_is_no_address_is_told_and_the_job_is_not_paid_for_again(place, tmp_path):
    cloud = Cloud(place=place)
    with serving(cloud) as served:
        session = quick(CallStore(tmp_path))
        with pytest.raises(BackendError, match="the result's address"):
            ask(served.url, session)
        assert [e.outcome for e in session.account.entries] == ["answered"] * 4
        cloud.place = ""
        assert ask(served.url, quick(CallStore(tmp_path))).name == "mug_1"
    assert cloud.jobs == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [b"[" * 200_000, b'{"Response":' * 9_000, b'{"Response": [1]}', b'{"Response": {"JobId": 5}}',
     b'{"Response": {"JobId": "\\u001b[2J"}}', b'{"Response": {"JobId": "' + b"x" * 999 + b'"}}',
     b'{"Response": {"Error": {"Code": ["x"], "Message": {}}}}'],
)  # fmt: skip
@pytest.mark.parametrize("kind", ["application/json", "text/plain"])
def test_a_submission_that_is_answered_oddly_is_told(body, kind):
    said = refused(lambda call: Answer(200, body, kind), quick(attempts=1))
    assert said.isprintable() and len(said) < 1000


@pytest.mark.parametrize(
    "files", [5, [5, {}], [{"Type": ["GLB"], "Url": 5}], [{"Type": "GLB", "Url": {}}]]
)
def test_a_result_of_other_types_has_no_glb(files):
    def answers(call):
        done = told(Status="DONE", ResultFile3Ds=files)
        return told(JobId="j") if call.headers["x-tc-action"] == SUBMIT else done

    assert "contains no GLB" in refused(answers)


def test_a_wrong_key_is_told_without_the_key(monkeypatch):
    monkeypatch.setenv("TENCENTCLOUD_SECRET_KEY", "another")
    said = refused(Cloud())
    assert "AuthFailure.SignatureFailure" in said
    assert "Check TENCENTCLOUD_SECRET_ID and TENCENTCLOUD_SECRET_KEY" in said


def test_a_message_that_repeats_the_key_is_redacted():
    assert "[redacted]" in refused(Cloud(errors={SUBMIT: ["InvalidParameter"]}))


def test_no_key_asks_nothing(monkeypatch):
    monkeypatch.delenv("TENCENTCLOUD_SECRET_ID")
    cloud = Cloud()
    assert "Set TENCENTCLOUD_SECRET_ID and TENCENTCLOUD_SECRET_KEY" in refused(cloud)
    assert not cloud.log


@pytest.mark.parametrize(
    ("first", "of", "told"),
    [
        ({"x": 1}, SUBMIT, None),
        ({"Response": {"RequestId": "1"}}, SUBMIT, None),
        ({"x": 1}, QUERY, "Check that http://127"),
    ],
)
def test_a_call_that_was_not_answered_is_made_again_and_loses_no_job(first, of, told, tmp_path):
    cloud, odd = Cloud(), [Answer.of(first)]

    def answer(call: Call) -> Answer:
        return odd.pop() if odd and call.headers["x-tc-action"] == of else cloud(call)

    with serving(answer) as served:
        with pytest.raises(BackendError, match=told):
            ask(served.url, quick(CallStore(tmp_path)))
        assert ask(served.url, quick(CallStore(tmp_path))).name == "mug_1"
    assert cloud.jobs == 1


def test_results_on_this_machine_may_come_over_plain_http():
    allowed = Tencent(hosts=("127.0.0.2", "localhost", "tencentcos.cn"))
    assert allowed._trusted("http", "127.0.0.2") and allowed._trusted("http", "localhost")
    assert not allowed._trusted("http", "a.tencentcos.cn")


@pytest.mark.parametrize(
    ("answer", "what"),
    [
        ([1, 2], "Check that http://127.0.0.1"),
        ({"Response": {"RequestId": "1"}}, "has no JobId"),
        ({"Response": None}, "returned status 200"),
    ],
)
def test_answers_of_another_shape_are_refused(answer, what):
    assert what in refused(lambda call: Answer.of(answer))


def test_a_result_without_glb_is_refused():
    def strip(call: Call, cloud=Cloud([{"Status": "DONE"}])) -> Answer:  # noqa: B008
        answer = cloud(call)
        return dataclasses.replace(answer, body=answer.body.replace(b'"GLB"', b'"OBJ"'))

    assert "the result contains no GLB. Available: OBJ." in refused(strip)


def test_settings_out_of_range_are_refused():
    with pytest.raises(BackendError, match="Did you mean 'LowPoly'"):
        Tencent(style="Lowpoly")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="asked_faces must"):
        Tencent(asked_faces=1000)
    cloud = Cloud()
    with serving(cloud) as served, pytest.raises(InputError, match=r"Normal\.faces must"):
        ask(served.url, faces=3)
    assert not cloud.log


@pytest.mark.slow
@pytest.mark.parametrize("before", range(340, 400, 7))
def test_a_key_that_a_quote_would_cut_in_two_is_found_all_the_same(before):
    def refuse(call: Call) -> Answer:
        return told(Error={"Code": "Bad", "Message": "x" * before + " " + KEY})

    def end(call: Call) -> Answer:
        if call.headers["x-tc-action"] == SUBMIT:
            return told(JobId="job-1")
        return told(Status="FAIL", ErrorMessage="x" * (before - 100) + " " + KEY)

    def talk(call: Call) -> Answer:
        return Answer(body=b"x" * (before - 320) + b" " + KEY.encode())

    for answer in (refuse, end, talk):
        with serving(answer) as served, pytest.raises(BackendError) as caught:
            ask(served.url)
        assert KEY[:5] not in str(caught.value)


@pytest.mark.parametrize("looks", [{}, {"@93.184.216.34": Price(call=9.0)}])
def test_looks_at_a_job_are_free_whatever_the_table_says(looks):
    request = httpx2.Request("POST", "https://93.184.216.34/", json={"JobId": "1"})
    sent = []

    class Client(httpx2.Client):
        def post(self, url, *, content, headers) -> httpx2.Response:
            sent.append(httpx2.Request("POST", request.url, content=content, headers=headers))
            return httpx2.Response(200, headers={KEPT: "k"}, json={"Response": {"JobId": "1"}})

    prices = Prices(models={"hunyuan-3d-pro": Price(call=0.4), **looks})
    service = Service(Client(), (ID, KEY), "https://h", "r", "w", quick(), 1.0, 1.0, Used(None))
    service.submit({}, "yes")
    service.look("1", "renew")
    assert [question(call, "tencent", prices).most for call in sent] == [0.4, 0.0]
    assert not [name for call in sent for name in call.headers if "free" in name]
