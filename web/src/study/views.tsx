/** Pictures that a click or Enter enlarges. */
import type { Picture, Store } from "./store";

interface Props {
  store: Store;
  /** All pictures of the scene, for browsing. */
  all: Picture[];
  picture: Picture;
}

export function View({ store, all, picture }: Props) {
  return (
    <button
      type="button"
      class="view"
      aria-label={store.texts.value.enlarge(picture.label)}
      onClick={() => {
        const at = all.findIndex((other) => other.source === picture.source);
        store.zoom.value = { pictures: all, at: Math.max(at, 0) };
      }}
    >
      <img src={picture.source} alt="" />
    </button>
  );
}
