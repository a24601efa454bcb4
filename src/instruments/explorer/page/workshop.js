// The part of the page that makes strings, bars, membranes and plates, and changes those that it made.

/// What a slider changes: the smallest and the largest number as powers of ten, and its unit.
const sliders = {
  length: {low: -1.3, high: 0.5, unit: "m"},
  width: {low: -1.3, high: 0.5, unit: "m"},
  tension: {low: 0, high: 4, unit: {string: "N", bar: "N", membrane: "N/m", plate: "N/m"}},
  stiffness: {low: -5, high: 4, unit: {string: "N m²", bar: "N m²", plate: "N m"}},
  density: {low: -3, high: 2, unit: {string: "kg/m", bar: "kg/m", membrane: "kg/m²", plate: "kg/m²"}},
  friction: {low: -5, high: -1, unit: ""},
};

const slidersOfKind = {
  string: ["length", "tension", "stiffness", "density", "friction"],
  bar: ["length", "stiffness", "density", "friction"],
  membrane: ["length", "tension", "density", "friction"],
  plate: ["length", "width", "tension", "stiffness", "density", "friction"],
};

class Workshop {
  constructor(explorer) {
    this.explorer = explorer;
    for (const kind of Object.keys(recipes)) element(`make-${kind}`).onclick = () => this.make(kind);
    for (const [key, {low, high}] of Object.entries(sliders)) {
      Object.assign(element(`made-${key}`), {min: low, max: high, step: 0.01, oninput: () => this.change(key)});
    }
    element("made-ends").onchange = ({target}) => this.remake({...this.recipe, ends: target.value});
    this.drawing = new Drawing(element("outline"), points => this.draw(points));
  }

  /// A new body, behind the last one.
  make(kind) {
    const {low, high} = boundsOf(bodies), gap = 0.1 * Math.max(...minus(high, low)), recipe = {kind, ...recipes[kind]};
    const first = kind === "membrane" ? 0.5 * recipe.length : 0;
    const position = [low[0] + first, high[1] + gap + first, low[2]];
    const count = bodies.filter(body => body.recipe?.kind === kind).length;
    this.explorer.add(madeBody(count ? `${kind} ${count + 1}` : kind, {...recipe, position}));
  }

  /// The controls of a body that the page made; none of others.
  show(recipe) {
    this.recipe = recipe;
    element("made").hidden = !recipe;
    if (!recipe) return;
    for (const key of Object.keys(sliders)) {
      element(`made-${key}`).value = Math.log10(recipe[key]);
      element(`made-${key}`).parentElement.hidden = !slidersOfKind[recipe.kind].includes(key);
      this.showNumber(key);
    }
    element("made-ends").value = recipe.ends ?? "";
    element("made-ends").parentElement.hidden = recipe.kind !== "bar";
    element("drawing").hidden = recipe.kind !== "membrane";
    if (recipe.kind === "membrane") this.drawing.show(recipe.outline);
  }

  showNumber(key) {
    const {unit} = sliders[key];
    element(`made-${key}-text`).textContent = `${Number((this.recipe[key] ?? 0).toPrecision(3))} ${unit[this.recipe.kind] ?? unit}`;
  }

  change(key) {
    this.recipe = {...this.recipe, [key]: 10 ** Number(element(`made-${key}`).value)};
    this.showNumber(key);
    clearTimeout(this.waiting);  // the pointer moves faster than bodies are made
    this.waiting = setTimeout(() => this.remake(this.recipe), 30);
  }

  /// A drawn line becomes the rim. If it can't, the page says why, and the membrane stays.
  draw(points) {
    try {
      this.remake({...this.recipe, outline: outlineOfDrawing(points)});
    } catch (error) {
      tell(error.message);
      this.show(this.recipe);
    }
  }

  remake(recipe) {
    clearTimeout(this.waiting);
    element("error").hidden = true;
    this.explorer.replace(madeBody(bodies[this.explorer.chosen].name, recipe));
    this.show(recipe);
  }
}
