/** Random numbers seeded by a text: equal texts give equal numbers in every browser. */

export type Random = () => number;

/** Returns a generator of numbers in [0, 1): sfc32, seeded by a hash (xmur3) of `text`. */
export function seededRandom(text: string): Random {
  const seed = hasher(text);
  let [a, b, c, counter] = [seed(), seed(), seed(), seed()];
  const next = (): number => {
    const sum = (((a + b) | 0) + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (c << 21) | (c >>> 11);
    c = (c + sum) | 0;
    return (sum >>> 0) / 4294967296;
  };
  for (let k = 0; k < 16; k++) next();
  return next;
}

/** Returns the items in random order. */
export function shuffle<T>(items: readonly T[], random: Random): T[] {
  const left = [...items];
  const found: T[] = [];
  while (left.length) found.push(...left.splice(Math.floor(random() * left.length), 1));
  return found;
}

/** Returns 16 random hexadecimal digits, which are not derived from the rater. */
export function newRater(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

function hasher(text: string): () => number {
  let hash = 1779033703 ^ text.length;
  for (let k = 0; k < text.length; k++) {
    hash = Math.imul(hash ^ text.charCodeAt(k), 3432918353);
    hash = (hash << 13) | (hash >>> 19);
  }
  return () => {
    hash = Math.imul(hash ^ (hash >>> 16), 2246822507);
    hash = Math.imul(hash ^ (hash >>> 13), 3266489909);
    hash ^= hash >>> 16;
    return hash >>> 0;
  };
}
