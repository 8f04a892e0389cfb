/** Plays an episode frame by frame, and reports the current time. */
import { signal } from "@preact/signals";
import type { Episode } from "../data";
import type { ModelData } from "../physics/protocol";
import { Playback } from "./playback";

export class Player {
  readonly playback = signal<Playback | null>(null);
  /** Seconds since the start of the episode. */
  readonly time = signal(0);
  readonly playing = signal(false);
  private asked = 0;
  private last = 0;

  /** @param show - draws an instant. */
  constructor(private readonly show: (qpos: Float32Array, marker: Float32Array) => void) {}

  start(episode: Episode, model: ModelData): void {
    this.stop();
    this.playback.value = new Playback(episode, model);
    this.setPlaying(true);
  }

  stop(): void {
    cancelAnimationFrame(this.asked);
    this.playback.value = null;
    this.playing.value = false;
  }

  setPlaying(playing: boolean): void {
    const { value } = this.playback;
    if (!value) return;
    if (playing && value.ended) value.seek(0);
    this.playing.value = playing;
    this.last = performance.now();
    this.tick();
  }

  seek(seconds: number): void {
    this.playback.value?.seek(seconds);
    this.tick();
  }

  private tick(): void {
    cancelAnimationFrame(this.asked);
    const { value } = this.playback;
    if (!value) return;
    const now = performance.now();
    if (this.playing.value) value.seek(value.time + (now - this.last) / 1000);
    this.last = now;
    const { qpos, marker } = value.now();
    this.show(qpos, marker);
    this.time.value = value.time;
    this.playing.value &&= !value.ended;
    if (this.playing.value) this.asked = requestAnimationFrame(() => this.tick());
  }
}
