/** The static page: `#/` is the gallery, `#/scene/ID` a scene, `#/beside/ID/ID` two scenes side by side. */
import { signal } from "@preact/signals";
import { render } from "preact";
import { fetchData, type Gallery, type SceneRow } from "../data";
import { followAddress, route, skip, useTitle } from "../ui/routing";
import "../ui/styles.css";
import { GalleryPage } from "./gallery";
import { BesidePage, EmbeddedPage, ScenePage } from "./scene";

const gallery = signal<Gallery | null>(null);
const error = signal<string | null>(null);

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
      <a class="skip" href="#main" onClick={skip}>
        Skip to content
      </a>
      <Routed gallery={gallery.value} />
    </>
  );
}

function Routed({ gallery }: { gallery: Gallery }) {
  const [kind, ...rest] = route.value;
  const ids = kind === "embed" ? rest.slice(0, 1) : rest;
  const rows = ids.map((id) => gallery.scenes.find((row) => row.id === id || row.name === id));
  const missing = rows.findIndex((row) => !row || row.error);
  if (kind && (missing >= 0 || rows.length === 0)) {
    return <Missing gallery={gallery} words={rows[missing]?.error ?? `There is no scene ${ids[missing] ?? kind}.`} />;
  }
  const found = rows as SceneRow[];
  if (kind === "scene") return <ScenePage key={found[0]!.id} gallery={gallery} row={found[0]!} />;
  if (kind === "embed") return <EmbeddedPage key={found[0]!.id} row={found[0]!} task={rest[1]} />;
  if (kind === "beside") return <BesidePage gallery={gallery} rows={found.slice(0, 4)} />;
  return <GalleryPage gallery={gallery} />;
}

function Missing({ gallery, words }: { gallery: Gallery; words: string }) {
  useTitle(gallery.title);
  return (
    <main id="main" class="page">
      <p class="message" role="alert">
        {words}
      </p>
      <a href="#/">{gallery.title}</a>
    </main>
  );
}

followAddress();
fetchData<Gallery>("gallery.json")
  .then((found) => (gallery.value = found))
  .catch((reason: unknown) => (error.value = reason instanceof Error ? reason.message : String(reason)));
render(<App />, document.getElementById("app")!);
