/** Builds the user study's page: one file with everything inside. */
import preact from "@preact/preset-vite";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";
import { licenseTexts } from "./licenses";

/** Puts the licences of the page's code into it: raters get the file alone. */
function ownLicenses(): Plugin {
  const children = licenseTexts(["preact", "@preact/signals"]);
  const attrs = { type: "text/plain", id: "licenses" };
  return {
    name: "own-licenses",
    transformIndexHtml: () => [{ tag: "script", attrs, children, injectTo: "body" }],
  };
}

export default defineConfig({
  base: "./",
  plugins: [preact(), ownLicenses(), viteSingleFile()],
  build: {
    outDir: "../tabletopgen_web/static",
    emptyOutDir: false,
    target: "es2022",
    rolldownOptions: { input: { study: "study.html" } },
  },
});
