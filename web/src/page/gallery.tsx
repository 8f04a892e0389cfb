/** The gallery: a card for each scene, and filters. */
import { signal, useComputed } from "@preact/signals";
import type { Gallery, SceneRow } from "../data";
import { addressOf, useTitle } from "../ui/routing";
import { contents, level, matches, NO_FILTER, themes, type Filter } from "./search";

/** Outlives the gallery's page, so that the way back from a scene leads to the same results. */
const filter = signal<Filter>(NO_FILTER);

export function GalleryPage({ gallery }: { gallery: Gallery }) {
  useTitle(gallery.title);
  const set = (change: Partial<Filter>): void => {
    filter.value = { ...filter.value, ...change };
  };
  const shown = useComputed(() => gallery.scenes.filter((row) => matches(row, filter.value)));
  return (
    <>
      <header class="bar">
        <h1>{gallery.title}</h1>
        <p class="quiet small end">{gallery.made}</p>
      </header>
      <main id="main" class="page">
        <form class="filters" role="search" onSubmit={(event) => event.preventDefault()}>
          <label class="grow">
            Search
            <input
              type="search"
              placeholder="mug, desk, office …"
              value={filter.value.words}
              onInput={(event) => set({ words: event.currentTarget.value })}
            />
          </label>
          <label>
            Theme
            <select value={filter.value.theme} onChange={(event) => set({ theme: event.currentTarget.value })}>
              <option value="">any</option>
              {themes(gallery.scenes).map((theme) => (
                <option key={theme}>{theme}</option>
              ))}
            </select>
          </label>
          <label>
            Difficulty
            <select
              value={filter.value.difficulty}
              onChange={(event) => set({ difficulty: event.currentTarget.value as Filter["difficulty"] })}
            >
              <option value="">any</option>
              <option>easy</option>
              <option>medium</option>
              <option>hard</option>
            </select>
          </label>
          <label class="row">
            <input
              type="checkbox"
              checked={filter.value.certified}
              onChange={(event) => set({ certified: event.currentTarget.checked })}
            />
            All tasks certified
          </label>
        </form>
        <p role="status" class="quiet">
          {shown.value.length} of {gallery.scenes.length} tables
        </p>
        {shown.value.length === 0 && (
          <p>
            No table matches. <button onClick={() => set(NO_FILTER)}>Clear the search</button>
          </p>
        )}
        <ul class="cards">
          {shown.value.map((row) => (
            <li key={row.id}>
              <Card row={row} />
            </li>
          ))}
        </ul>
      </main>
    </>
  );
}

function Card({ row }: { row: SceneRow }) {
  if (row.error) {
    return (
      <div class="card">
        <div class="text">
          <h2>{row.name}</h2>
          <p class="bad small">Cannot be shown: {row.error}</p>
        </div>
      </div>
    );
  }
  return (
    <a class="card" href={addressOf("scene", row.id)}>
      {row.thumbnail ? <img class="picture" loading="lazy" alt="" src={row.thumbnail} /> : <div class="picture" />}
      <div class="text">
        <h2>{row.name}</h2>
        <p class="small quiet">{contents(row)}</p>
        <div class="tags">
          {row.theme && <span class="tag">{row.theme}</span>}
          {level(row) && <span class="tag">{level(row)}</span>}
          {row.gate && <span class={`tag ${row.gate.passed ? "good" : "bad"}`}>gate {row.gate.passed ? "passed" : "failed"}</span>}
          {row.certificate && (
            <span class="tag">
              {row.certificate.certified} of {row.certificate.instances} tasks certified
            </span>
          )}
        </div>
      </div>
    </a>
  );
}
