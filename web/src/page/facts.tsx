/** Facts about a scene: objects, gate, certificate, downloads. */
import { Fragment } from "preact";
import type { CertificateRow, Download, GateRow, SceneFiles, ThingRow } from "../data";

const cm = (size: readonly number[]): string => size.map((v) => (100 * v).toFixed(1)).join(" × ");

const small = (metres: number): string =>
  metres < 1e-3 ? `${(1e6 * metres).toFixed(0)} µm` : `${(1e3 * metres).toFixed(1)} mm`;

const bytes = (n: number): string => (n < 1e6 ? `${Math.ceil(n / 1e3)} kB` : `${(n / 1e6).toFixed(1)} MB`);

export function Facts({ files, base, selected }: { files: SceneFiles; base: string; selected: string | null }) {
  const { row } = files;
  return (
    <div class="stack">
      {row.warnings.length > 0 && (
        <section class="panel">
          <h2>Notes</h2>
          {row.warnings.map((words) => (
            <p class="small" key={words}>
              {words}
            </p>
          ))}
        </section>
      )}
      {files.picture && (
        <details class="panel">
          <summary>{files.picture.kind === "reference" ? "The picture" : "The render"}</summary>
          <img
            loading="lazy"
            src={base + files.picture.file}
            alt={files.picture.kind === "reference" ? `Input picture of ${row.name}` : `Render of ${row.name}`}
          />
        </details>
      )}
      <Things things={row.things} table={row.table.size} selected={selected} />
      {row.gate && <Gate gate={row.gate} />}
      {row.certificate && <Certificate certificate={row.certificate} />}
      <Downloads downloads={files.downloads} base={base} />
    </div>
  );
}

function Things({ things, table, selected }: { things: ThingRow[]; table: readonly number[]; selected: string | null }) {
  return (
    <section class="panel">
      <h2>Objects</h2>
      <div class="scroll" tabIndex={0} role="region" aria-label="Objects">
        <table>
          <thead>
            <tr>
              <th scope="col">name</th>
              <th scope="col">size, cm</th>
              <th scope="col" class="number">
                kg
              </th>
            </tr>
          </thead>
          <tbody>
            {things.map((thing) => (
              <tr key={thing.name} aria-current={thing.name === selected ? "true" : undefined}>
                <td class="named">
                  <Breaking name={thing.name} />
                  {!thing.name.startsWith(thing.label.replaceAll(" ", "_")) && <span class="quiet"> ({thing.label})</span>}
                </td>
                <td class="whole">{cm(thing.size)}</td>
                <td class="number">{thing.mass.toFixed(3)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="small quiet">Table {cm(table)} cm</p>
    </section>
  );
}

/** A name that may wrap after an underscore. */
function Breaking({ name }: { name: string }) {
  const [first, ...rest] = name.split("_");
  return (
    <>
      {first}
      {rest.map((part, k) => (
        <Fragment key={k}>
          <wbr />_{part}
        </Fragment>
      ))}
    </>
  );
}

function Gate({ gate }: { gate: GateRow }) {
  return (
    <section class="panel">
      <h2>
        Physical gate: <span class={gate.passed ? "good" : "bad"}>{gate.passed ? "passed" : "failed"}</span>
      </h2>
      <table>
        <tbody>
          <tr>
            <th scope="row">deepest overlap</th>
            <td class="number">{small(gate.penetration)}</td>
          </tr>
          <tr>
            <th scope="row">largest drift</th>
            <td class="number">{small(gate.drift)}</td>
          </tr>
          <tr>
            <th scope="row">largest tilt</th>
            <td class="number">{((180 / Math.PI) * gate.tilt).toFixed(3)}°</td>
          </tr>
        </tbody>
      </table>
      {gate.failures.map((words) => (
        <p class="small bad" key={words}>
          {words}
        </p>
      ))}
    </section>
  );
}

function Certificate({ certificate }: { certificate: CertificateRow }) {
  return (
    <section class="panel">
      <h2>Certificate of the scripted expert</h2>
      <table>
        <thead>
          <tr>
            <th scope="col">task</th>
            <th scope="col" class="number">
              instances certified
            </th>
            <th scope="col" class="number">
              episodes solved
            </th>
          </tr>
        </thead>
        <tbody>
          {certificate.tasks.map(({ task, certified, instances, rate }) => (
            <tr key={task}>
              <th scope="row">{task}</th>
              <td class="number">
                {certified} of {instances}
              </td>
              <td class="number">{(100 * rate).toFixed(0)} %</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="small quiet">An instance, such as an object to lift, is certified if the expert solves it from every tested start.</p>
    </section>
  );
}

export function Downloads({ downloads, base }: { downloads: Download[]; base: string }) {
  if (downloads.length === 0) return null;
  return (
    <section class="panel">
      <h2>Downloads</h2>
      {downloads.map(({ label, file, bytes: size }) => (
        <a key={file} href={base + file} download={file.split("/").pop()}>
          {label} <span class="quiet small">({bytes(size)})</span>
        </a>
      ))}
    </section>
  );
}
