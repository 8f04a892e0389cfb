/** Builds the pages that load others of their files: the gallery with its viewer, and the studio. */
import preact from "@preact/preset-vite";
import { defineConfig } from "vite";
import { licenses } from "./licenses";

export default defineConfig({
  base: "./",
  plugins: [preact(), licenses()],
  worker: { format: "es" },
  build: {
    outDir: "../tabletopgen_web/static",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    rolldownOptions: { input: { page: "page.html", studio: "studio.html" } },
  },
});
