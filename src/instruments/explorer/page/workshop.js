// The part of the page that makes strings, bars, membranes and plates, and changes those that it made.

/// What a slider changes, by the kind of body: the smallest and the largest number as powers of ten, and the unit.
const sliders = {
  length: {string: [-1, 0.5, "m"], bar: [-1.3, 0.3, "m"], membrane: [-1.3, 0.3, "m"], plate: [-1.3, 0.3, "m"]},
  width: {plate: [-1.3, 0.3, "m"]},
  tension: {string: [0, 3.5, "N"], membrane: [1, 4.5, "N/m"], plate: [0, 4.5, "N/m"]},
  stiffness: {string: [-6, 0, "N m²"], bar: [-1, 4, "N m²"], plate: [-1, 4, "N m"]},
  density: {string: [-4, -1, "kg/m"], bar: [-2, 1.5, "kg/m"], membrane: [-1, 1, "kg/m²"], plate: [0, 2, "kg/m²"]},
  friction: {string: [-5, -1, ""], bar: [-5, -1, ""], membrane: [-5, -1, ""], plate: [-5, -1, ""]},
};

class Workshop {
  constructor(explorer) {
    this.explorer = explorer;
    for (const kind of Object.keys(recipes)) element(`make-${kind}`).onclick = () => this.make(kind);
    for (const key of Object.keys(sliders)) element(`made-${key}`).oninput = () => this.change(key);
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
    clearTimeout(this.waiting);
    this.recipe = recipe;
    element("made").hidden = !recipe;
    if (!recipe) return;
    for (const [key, {[recipe.kind]: limits}] of Object.entries(sliders)) {
      element(`made-${key}`).parentElement.hidden = !limits;
      if (!limits) continue;
      const [min, max] = limits;
      Object.assign(element(`made-${key}`), {min, max, step: 0.01});
      element(`made-${key}`).value = Math.max(min, Math.log10(recipe[key]));
      this.showNumber(key);
    }
    element("made-ends").value = recipe.ends ?? "";
    element("made-ends").parentElement.hidden = recipe.kind !== "bar";
    element("drawing").hidden = recipe.kind !== "membrane";
    if (recipe.kind === "membrane") this.drawing.show(recipe.outline);
  }

  showNumber(key) {
    const [, , unit] = sliders[key][this.recipe.kind];
    element(`made-${key}-text`).textContent = `${Number(this.recipe[key].toPrecision(3))} ${unit}`;
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
