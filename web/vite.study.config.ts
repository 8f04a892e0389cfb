/** Builds the user study's page: one file with everything inside. */
import preact from "@preact/preset-vite";
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

export default defineConfig({
  base: "./",
  plugins: [preact(), viteSingleFile()],
  build: {
    outDir: "../tabletopgen_web/static",
    emptyOutDir: false,
    target: "es2022",
    rolldownOptions: { input: { study: "study.html" } },
  },
});
