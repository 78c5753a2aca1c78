// SPDX-License-Identifier: Apache-2.0
// Which view is taken and which layers are drawn, over the field.
import { make } from "../app/dom";
import { LAYERS, type Layer } from "../drawing/beliefs";
import { VIEWS, type ViewName } from "../drawing/views";

const VIEW_WORDS: Record<ViewName, string> = {
  broadcast: "Broadcast",
  orbit: "Free",
  follow: "Follow",
  eye: "Robot’s eye",
  above: "Above",
};

export class FieldControls {
  readonly element: HTMLElement;
  private readonly views = new Map<ViewName, HTMLButtonElement>();
  private readonly boxes = new Map<Layer, HTMLInputElement>();

  constructor(
    onView: (view: ViewName) => void,
    private readonly onLayer: (layer: Layer, on: boolean) => void,
  ) {
    const views = make(
      "div",
      { class: "segments", role: "group", "aria-label": "View (key v)" },
      ...VIEWS.map((view) => {
        const choice = make(
          "button",
          { type: "button", "aria-pressed": "false", click: () => onView(view) },
          VIEW_WORDS[view],
        );
        this.views.set(view, choice);
        return choice;
      }),
    );
    const layers = make(
      "details",
      { class: "layers" },
      make("summary", {}, "Layers"),
      make(
        "fieldset",
        { "aria-label": "Layers" },
        ...(Object.keys(LAYERS) as Layer[]).map((layer) => this.box(layer)),
      ),
    );
    this.element = make("div", { class: "field-controls" }, views, layers);
  }

  private box(layer: Layer): HTMLElement {
    const input = make("input", { type: "checkbox", name: layer });
    input.addEventListener("change", () => this.onLayer(layer, input.checked));
    this.boxes.set(layer, input);
    return make("label", {}, input, LAYERS[layer]);
  }

  show(view: ViewName, layers: ReadonlySet<Layer>): void {
    for (const [name, choice] of this.views)
      choice.setAttribute("aria-pressed", String(name === view));
    for (const [layer, box] of this.boxes) box.checked = layers.has(layer);
  }
}
