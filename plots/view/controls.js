// What a reader can ask for by buttons and keys. Each of them is one line of `keys`.

const by = (id) => document.getElementById(id);

/** page: what main.js lets others do. */
export function controls(page) {
  const { state } = page;
  const toggle = (name) => page.set({ [name]: !state[name] });
  const next = (id, by_) => {
    const select = by(id), n = select.options.length;
    select.selectedIndex = (select.selectedIndex + by_ + n) % n;
    select.dispatchEvent(new Event("change"));
  };
  const pan = (x, y) => page.camera.pan(60 * x, 60 * y);
  const keys = [
    ["space", "play, or stop", () => toggle("playing"), [" "]],
    ["\u2190 \u2192", "a frame back, on", (e) => page.step(e.key === "ArrowLeft" ? -1 : 1),
     ["ArrowLeft", "ArrowRight"]],
    ["page up, page down", "ten frames back, on", (e) => page.step(e.key === "PageUp" ? -10 : 10),
     ["PageUp", "PageDown"]],
    ["home, end", "first frame, last", (e) => page.goTo(e.key === "Home" ? 0 : Infinity),
     ["Home", "End"]],
    ["+ \u2212", "zoom in, out", (e) => page.camera.zoom(e.key === "-" ? 0.8 : 1.25),
     ["+", "=", "-"]],
    ["w a s d", "go up, left, down, right",
     (e) => pan(...{ w: [0, -1], a: [-1, 0], s: [0, 1], d: [1, 0] }[e.key]), ["w", "a", "s", "d"]],
    ["0", "the whole view", () => page.camera.fit(page.data.run.window), ["0"]],
    ["v", "show another quantity", () => next("what", 1), ["v"]],
    ["m", "other colours", () => next("colours", 1), ["m"]],
    ["l", "logarithmic colours, or linear", () => toggle("log"), ["l"]],
    ["[ ]", "colours end at less, at more",
     (e) => page.set({ gain: state.gain * (e.key === "[" ? 1 / 1.25 : 1.25) }), ["[", "]"]],
    ["c", "quadtree cells", () => toggle("cells"), ["c"]],
    ["p", "pick what is nearest to the middle", () => page.pickMiddle(), ["p"]],
    ["escape", "let go of it", () => page.set({ picked: -1 }), ["Escape"]],
    ["?", "these keys", () => help(), ["?"]],
  ];

  const dialog = by("keys");
  const shut = () => by("plane").focus({ preventScroll: true });
  const help = () => {
    dialog.open ? (dialog.close(), shut()) : dialog.showModal();
    by("help").setAttribute("aria-expanded", dialog.open);
  };
  const list = document.createElement("dl");
  const shown = keys.filter(([key]) => key !== "c" || page.data.run.cells);
  for (const [key, words] of [...shown, ["wheel, two fingers", "zoom"], ["drag", "move"],
                              ["touch", "pick"]]) {
    for (const [tag, text] of [["dt", key], ["dd", words]])
      list.append(Object.assign(document.createElement(tag), { textContent: text }));
  }
  const close = Object.assign(document.createElement("button"), { textContent: "close" });
  close.addEventListener("click", help);
  dialog.append(list, close);
  dialog.addEventListener("close", () => {
    by("help").setAttribute("aria-expanded", false);
    shut();
  });

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (dialog.open && !["?", "Escape"].includes(event.key)) return;
    if (dialog.open && event.key === "Escape") return;  // closes by itself
    const own = event.target.closest?.("select, button, input[type=checkbox]");
    if (own && [" ", "Enter", "ArrowLeft", "ArrowRight", "Home", "End"].includes(event.key)) return;
    if (own?.tagName === "SELECT" && event.key.length === 1) return;
    const found = keys.find(([, , , names]) => names.includes(event.key));
    if (!found) return;
    event.preventDefault();
    found[2](event);
  });

  const change = (id, kind, act) => by(id).addEventListener(kind, () => act(by(id)));
  change("play", "click", () => toggle("playing"));
  change("back", "click", () => page.step(-1));
  change("on", "click", () => page.step(1));
  change("slider", "input", (slider) => page.goTo(Number(slider.value)));
  change("log", "change", (box) => page.set({ log: box.checked }));
  change("cells", "change", (box) => page.set({ cells: box.checked }));
  change("fit", "click", () => page.camera.fit(page.data.run.window));
  change("help", "click", help);
  change("what", "change", (select) => page.set({ what: select.value, gain: 1 }));
  change("colours", "change", (select) => page.set({ colours: select.value }));
  by("cells-label").hidden = !page.data.run.cells;
  for (const [id, names] of [["what", Object.entries(page.data.run.shown)]])
    by(id).append(...names.map(([value, { words }]) => new Option(words, value)));
}

/** What the controls say of a page. */
export function tell({ state, data, time }) {
  const { frames, shown, colours } = data.run, select = by("colours");
  const named = Object.keys(colours).filter((name) =>
    colours[name].signs === shown[state.what].signs);
  if ([...select.options].map((o) => o.value).join() !== named.join())
    select.replaceChildren(...named.map((name) => new Option(name, name)));
  select.value = state.colours;
  by("what").value = state.what;
  by("log").checked = state.log;
  by("log").disabled = shown[state.what].plain;
  by("cells").checked = state.cells;
  by("slider").max = Math.max(frames.length - 1, 0);
  by("slider").value = state.k;
  by("slider").setAttribute("aria-valuetext", time);
  const place = `${time}  (${state.k + 1}/${frames.length})`;
  by("time").textContent = frames.length ? place : "no frame yet";
  by("play").textContent = state.playing ? "\u275a\u275a" : "\u25b6\ufe0e";
  by("play").setAttribute("aria-label", state.playing ? "stop" : "play");
}
