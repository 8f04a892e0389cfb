"""Replaces the process of a job and acts as the job's text demands."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path


def say(**message: object) -> None:
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


def wait_for_ever() -> None:
    while True:
        time.sleep(0.05)


def end_with_parent() -> None:
    sys.stdin.read()
    os._exit(1)


def main() -> int:
    order = json.loads(sys.stdin.readline())
    threading.Thread(target=end_with_parent, daemon=True).start()
    text = order["request"].get("text", "")
    if order["kind"] == "estimate":
        say(type="result", roles=[], calls=[f"Would ask {text}."], asks_servers=True)
        return 0
    say(type="stage", name="fake", number=1, total=2)
    figures = Path(order["figures"])
    figures.mkdir(parents=True, exist_ok=True)
    (figures / "seen.png").write_bytes(b"\x89PNG\r\n\x1a\n")
    say(type="figure", name="seen.png", stage="fake")
    match text.split()[0]:
        case "slow":
            wait_for_ever()
        case "stubborn":
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
            say(type="stage", name="deaf", number=2, total=2)
            wait_for_ever()
        case "fails":
            say(type="error", message="The mug is broken.")
            return 1
        case "occupied":
            facts = {"place": "occupied", "free_position": [0.1, 0.2]}
            say(type="error", message="A mug is in the way.", facts=facts)
            return 1
        case "crashes":
            os.kill(os.getpid(), signal.SIGSEGV)
        case "silent":
            return 3
        case "babbles":
            print("no JSON at all", flush=True)
            wait_for_ever()
        case "shouts":
            print("x" * 3_000_000, flush=True)
            wait_for_ever()
        case "unknown":
            say(type="stage", name="without a number")
            wait_for_ever()
        case "logs":
            print(os.environ.get("TEST_API_KEY", ""), "\x1b[2J", file=sys.stderr)
            for number in range(5000):
                print("line", number, "y" * 600, file=sys.stderr)
    time.sleep(0.02)
    say(type="result", scene="fake-000000000000", facts={"text": text})
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
