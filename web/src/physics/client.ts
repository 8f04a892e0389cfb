/** The page's side of the physics worker. */
import { mujocoModule } from "./module";
import type { Answer, Command, Frame, ModelData, Placed, Reply, State } from "./protocol";

interface Waiting {
  resolve: (value: Answer) => void;
  reject: (reason: Error) => void;
}

export class Physics {
  private worker: Worker | null = null;
  private closed = false;
  /** Why the worker has failed; null if it has not. */
  private broken: string | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private next = 1;

  /**
   * `begin` starts the worker; a client without `begin` needs no `close`.
   *
   * @param onFrame - called with every frame to draw.
   * @param onBreak - called once if the worker itself fails: no WebAssembly, out of memory.
   */
  constructor(
    private readonly onFrame: (frame: Frame) => void,
    private readonly onBreak: (message: string) => void,
  ) {}

  /** Starts the worker; the first request does so, too. */
  begin(): void {
    if (this.worker || this.closed) return;
    mujocoModule().catch(() => {}); // started early; whoever loads a scene receives the failure
    this.worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    this.worker.onmessage = (event: MessageEvent<Reply>) => this.heed(event.data);
    this.worker.onerror = (event) => {
      const message = event.message || "The physics could not be started in this browser.";
      this.broken = message;
      for (const { reject } of this.waiting.values()) reject(new Error(message));
      this.waiting.clear();
      this.onBreak(message);
    };
  }

  async load(xml: string, files: [string, Uint8Array][], start: string): Promise<ModelData> {
    const module = await mujocoModule();
    return (await this.ask({ kind: "load", module, xml, files, start })) as ModelData;
  }

  async state(): Promise<State> {
    return (await this.ask({ kind: "state" })) as State;
  }

  /** The bodies that the given bodies would overlap at other positions. */
  async overlaps(placed: Placed[]): Promise<number[]> {
    return (await this.ask({ kind: "overlaps", placed })) as number[];
  }

  /** Sends a command; resolves when it is done, and never after this is closed. */
  ask(command: Command): Promise<Answer> {
    this.begin();
    const id = this.next++;
    return new Promise((resolve, reject) => {
      if (this.closed) return;
      if (this.broken !== null) return reject(new Error(this.broken));
      this.waiting.set(id, { resolve, reject });
      this.worker?.postMessage({ ...command, id });
    });
  }

  /** Sends a command without awaiting a result. */
  tell(command: Command): void {
    if (this.broken === null) this.ask(command).catch((error: unknown) => console.warn("physics:", error));
  }

  close(): void {
    this.closed = true;
    this.worker?.terminate();
    this.waiting.clear();
  }

  private heed(reply: Reply): void {
    if (reply.kind === "frame") {
      this.onFrame(reply.frame);
      return;
    }
    const waiting = this.waiting.get(reply.id);
    this.waiting.delete(reply.id);
    if (reply.kind === "done") waiting?.resolve(reply.value);
    else waiting?.reject(new Error(reply.message));
  }
}
