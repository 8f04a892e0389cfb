/** The static page: `#/` is the gallery, `#/scene/ID` a scene, `#/beside/ID/ID` two of them. */
import { signal } from "@preact/signals";
import { render } from "preact";
import { fetchData, type Gallery, type SceneRow } from "../data";
import "../ui/styles.css";
import { GalleryPage } from "./gallery";
import { BesidePage, EmbeddedPage, ScenePage } from "./scene";

const gallery = signal<Gallery | null>(null);
const error = signal<string | null>(null);
const route = signal<string[]>(parts());

function parts(): string[] {
  return location.hash.replace(/^#\/?/, "").split("/").filter(Boolean).map(decode);
}

function decode(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part; // a damaged address names no scene
  }
}

function App() {
  if (error.value) {
    return (
      <main class="page">
        <p class="message" role="alert">
          {error.value}
        </p>
      </main>
    );
  }
  if (!gallery.value) return <main class="page"><p role="status">Loading …</p></main>;
  return (
    <>
      <a class="skip" href="#main" onClick={(event) => skip(event)}>
        Skip to the content
      </a>
      <Routed gallery={gallery.value} />
    </>
  );
}

function skip(event: Event): void {
  event.preventDefault(); // the address is the route
  const main = document.getElementById("main");
  main?.setAttribute("tabindex", "-1");
  main?.focus();
}

function Routed({ gallery }: { gallery: Gallery }) {
  const [kind, ...rest] = route.value;
  const ids = kind === "embed" ? rest.slice(0, 1) : rest;
  const rows = ids.map((id) => gallery.scenes.find((row) => row.id === id || row.name === id));
  const missing = rows.findIndex((row) => !row || row.error);
  if (kind && (missing >= 0 || rows.length === 0)) {
    return (
      <main class="page">
        <p class="message" role="alert">
          {rows[missing]?.error ?? `There is no scene called ${ids[missing] ?? kind} here.`}
        </p>
        <a href="#/">{gallery.title}</a>
      </main>
    );
  }
  const found = rows as SceneRow[];
  if (kind === "scene") return <ScenePage key={found[0]!.id} gallery={gallery} row={found[0]!} />;
  if (kind === "embed") return <EmbeddedPage key={found[0]!.id} row={found[0]!} task={rest[1]} />;
  if (kind === "beside") return <BesidePage gallery={gallery} rows={found.slice(0, 4)} />;
  document.title = gallery.title;
  return <GalleryPage gallery={gallery} />;
}

addEventListener("hashchange", () => {
  route.value = parts();
  scrollTo(0, 0);
});
fetchData<Gallery>("gallery.json")
  .then((found) => (gallery.value = found))
  .catch((reason: unknown) => (error.value = reason instanceof Error ? reason.message : String(reason)));
render(<App />, document.getElementById("app")!);
