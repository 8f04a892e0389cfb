// Prints what the Khronos validator finds in GLB files, as JSON: a report for each path.
//
//     node validate_gltf.cjs MODULES FILE...
//
// MODULES is the folder node_modules that holds gltf-validator.

const { readFileSync } = require("node:fs");
const { join } = require("node:path");

const [modules, ...files] = process.argv.slice(2);
const { validateBytes } = require(join(modules, "gltf-validator"));

async function main() {
  const reports = {};
  for (const file of files) {
    const bytes = new Uint8Array(readFileSync(file));
    reports[file] = (await validateBytes(bytes, { uri: file, maxIssues: 0 })).issues;
  }
  process.stdout.write(JSON.stringify(reports));
}

main();
