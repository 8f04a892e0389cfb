/** MuJoCo's WebAssembly, fetched and compiled once for all workers of a page. */
import address from "../../node_modules/@mujoco/mujoco/mujoco.wasm?url";

let compiled: Promise<WebAssembly.Module> | null = null;

/** Starts to fetch and compile unless already started; resolves to the module. */
export function mujocoModule(): Promise<WebAssembly.Module> {
  compiled ??= compile().catch((error: unknown) => {
    compiled = null; // another attempt may succeed
    throw error;
  });
  return compiled;
}

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`mujoco.wasm is missing (${response.status}).`);
  if (response.headers.get("Content-Type")?.startsWith("application/wasm")) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer()); // a host without the content type
}
