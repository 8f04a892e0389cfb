/** The physics worker: MuJoCo's WebAssembly, stepped in real time outside the page's thread. */
import loadMujoco, { type MainModule } from "@mujoco/mujoco";
import type { Answer, Frame, ModelData, Reply, Request } from "./protocol";
import { Simulation } from "./simulation";

/** Maximum backlog in simulated seconds; a slow machine falls behind real time. */
const MOST_BEHIND = 0.05;
/** Milliseconds between two frames, and the maximum share of them for steps. */
const FRAME = 16;
const BUSY = 12;

let mujoco: Promise<MainModule> | null = null;
let simulation: Simulation | null = null;
let running = false;
let shown = { centres: false, contacts: false };
let owed = 0;
let last = 0;
let timer = 0;

const send = (reply: Reply, transfer: Transferable[] = []): void => self.postMessage(reply, { transfer });

function sendFrame(): void {
  if (!simulation) return;
  const frame: Frame = simulation.frame(running, shown.centres, shown.contacts);
  const buffers = [frame.poses.buffer, frame.centres?.buffer, frame.contacts?.buffer];
  send({ kind: "frame", frame }, buffers.filter((b): b is ArrayBuffer => b !== undefined));
}

function tick(): void {
  if (!simulation || !running) return;
  const now = performance.now();
  owed = Math.min(owed + (now - last) / 1000, MOST_BEHIND);
  last = now;
  const { timestep } = simulation;
  while (owed >= timestep && performance.now() - now < BUSY) {
    simulation.step(1);
    owed -= timestep;
  }
  sendFrame();
  timer = self.setTimeout(tick, Math.max(FRAME - (performance.now() - now), 1));
}

function run(now: boolean): void {
  self.clearTimeout(timer);
  running = now;
  owed = 0;
  last = performance.now();
  if (running) tick();
  else sendFrame();
}

/** Starts MuJoCo from its compiled module. */
function start(module: WebAssembly.Module): Promise<MainModule> {
  return new Promise((resolve, reject) => {
    loadMujoco({
      instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
        WebAssembly.instantiate(module, imports).then(done, reject); // fails without enough memory
        return {};
      },
    }).then(resolve, reject);
  });
}

async function load(request: Request & { kind: "load" }): Promise<ModelData> {
  const found = await (mujoco ??= start(request.module));
  run(false);
  simulation?.delete();
  simulation = null;
  simulation = Simulation.compile(found, request.xml, request.files, request.start);
  return simulation.described;
}

/** The large arrays of a model: transferred rather than copied, since the worker no longer needs them. */
function buffersOf({ meshes, textures }: ModelData): ArrayBufferLike[] {
  const corners = meshes.flatMap(({ positions, normals, uvs }) => [positions.buffer, normals.buffer, ...(uvs ? [uvs.buffer] : [])]);
  return [...corners, ...textures.map(({ pixels }) => pixels.buffer)];
}

function heed(request: Request): Answer {
  if (!simulation) throw new Error("No scene is loaded.");
  switch (request.kind) {
    case "run":
      run(request.running);
      return null;
    case "step":
      simulation.step(request.steps);
      break;
    case "reset":
      simulation.reset();
      break;
    case "show":
      shown = { centres: request.centres, contacts: request.contacts };
      simulation.allowSleep(!request.contacts);
      break;
    case "drag":
      simulation.hold(request.body, request.grip, request.target);
      return null;
    case "release":
      simulation.release();
      return null;
    case "pose":
      simulation.pose(request.qpos, request.marker);
      break;
    case "arm":
      simulation.drive(request.action);
      return null;
    case "state":
      return simulation.state();
    case "overlaps":
      return simulation.overlaps(request.placed);
    case "load":
      return null;
  }
  if (!running) sendFrame();
  return null;
}

self.onmessage = async (event: MessageEvent<Request>): Promise<void> => {
  const request = event.data;
  try {
    if (request.kind === "load") {
      const value = await load(request);
      send({ kind: "done", id: request.id, value }, buffersOf(value));
      sendFrame();
    } else {
      send({ kind: "done", id: request.id, value: heed(request) });
    }
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    send({ kind: "failed", id: request.id, message: message.trim() });
  }
};
