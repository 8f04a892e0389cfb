"""Hand-made MJCF files like those of other programs."""

from pathlib import Path

TABLE = '<body name="table" pos="1 2 0"><geom type="box" size=".6 .4 .37" pos="0 0 .37"/></body>'
CUBE = '<body name="cube" pos="1 2 .77"><freejoint/><geom type="box" size=".03 .03 .03"/></body>'


def write(folder: Path, body: str = TABLE + CUBE, head: str = "", name: str = "scene.xml") -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"<mujoco>{head}<worldbody>{body}</worldbody></mujoco>")
    return path
