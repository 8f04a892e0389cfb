/** Writes `licenses.md`: the licences of every package whose code is in the built pages. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const HERE = dirname(fileURLToPath(import.meta.url));

interface Package {
  name: string;
  version: string;
  license: string;
  dependencies?: Record<string, string>;
}

const read = (path: string): Package => JSON.parse(readFileSync(path, "utf8")) as Package;

/** Returns the text of a package's licence; Apache's is this project's own where it ships none. */
function textOf(folder: string, license: string): string {
  const found = readdirSync(folder).find((name) => /^licen[cs]e/i.test(name));
  if (found) return readFileSync(join(folder, found), "utf8");
  if (license === "Apache-2.0") return readFileSync(join(HERE, "..", "LICENSE"), "utf8");
  throw new Error(`${folder} has no licence file, and its licence is ${license}.`);
}

function collect(names: string[], seen: Map<string, string>): void {
  for (const name of names) {
    const folder = join(HERE, "node_modules", name);
    if (seen.has(name) || !existsSync(folder)) continue;
    const { version, license, dependencies } = read(join(folder, "package.json"));
    seen.set(name, `## ${name} ${version} (${license})\n\n${textOf(folder, license).trim()}\n`);
    collect(Object.keys(dependencies ?? {}), seen);
  }
}

/** Returns the licences of packages and of what they depend on, as Markdown. */
export function licenseTexts(names: string[]): string {
  const seen = new Map<string, string>();
  collect(names, seen);
  return ["# Licences of what these pages contain\n", ...seen.values()].join("\n");
}

export function licenses(): Plugin {
  return {
    name: "licenses",
    generateBundle() {
      const names = Object.keys(read(join(HERE, "package.json")).dependencies ?? {});
      const source = licenseTexts(names);
      this.emitFile({ type: "asset", fileName: "licenses.md", source });
    },
  };
}
