// node controls.mjs PAGE SCREENSHOT [MADE]: opens the Sonic Explorer in Chromium without a window and looks at the first view; clicks
// beside each body; makes bodies of the kinds MADE; moves every control over its range, strikes and listens; makes the sound
// clip; ends the audio thread by an error and strikes again. Prints what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, screenshot, made] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 800, 500);

/// The largest share of the canvas that a vertex is away from its middle; more than 1 is outside.
const reach = () => page.evaluate(() => {
  const {view} = window.idiophone.explorer, {clientWidth, clientHeight} = view.canvas;
  let farthest = 0;
  for (const {vertices} of view.bodies) {
    view.onScreen(vertices).forEach((at, i) => {
      if (i % 3 < 2) farthest = Math.max(farthest, Math.abs(2 * at / (i % 3 ? clientHeight : clientWidth) - 1));
    });
  }
  return farthest;
});
const first = {wide: await reach()};
await page.setViewportSize({width: 390, height: 760});  // a phone, turned
await page.waitForTimeout(100);
first.narrow = await reach();
await page.setViewportSize({width: 800, height: 500});
await page.waitForTimeout(100);
await page.screenshot({path: screenshot});

const strikes = () => page.evaluate(() => window.idiophone.explorer.strikes);
const room = await page.locator("#room").boundingBox();
const clicked = [];  // names of the bodies that answer to a click five pixels beside their first triangle
for (const index of await page.evaluate(() => [...window.idiophone.bodies.keys()])) {
  const [x, y] = await page.evaluate(body => {
    const {view} = window.idiophone.explorer, {vertices, triangles} = view.bodies[body], seen = view.onScreen(vertices);
    return [0, 1].map(axis => [0, 1, 2].reduce((sum, corner) => sum + seen[3 * triangles[corner] + axis] / 3, 0));
  }, index);
  const before = await strikes();
  await page.mouse.click(room.x + x - 2, room.y + y + 4);
  await page.waitForFunction(count => window.idiophone.explorer.strikes > count, before, {timeout: 5000}).catch(() => null);
  clicked.push((await page.locator("#blow").textContent()).split(" ")[0]);
}

/// Strikes the chosen body where its first mode moves most; whether something louder than a limit is heard.
const heard = async (limit = 1e-9) => {
  const sounds = await page.evaluate(async least => {
    const {explorer, bodies} = window.idiophone, body = bodies[explorer.chosen];
    const swing = vertex => Math.hypot(...body.shape.subarray(3 * vertex, 3 * vertex + 3));
    const vertex = [...Array(body.vertices.length / 3).keys()].reduce((most, other) => swing(other) > swing(most) ? other : most);
    const triangle = Math.floor(body.triangles.indexOf(vertex) / 3), weights = [0.3, 0.3, 0.4];
    await explorer.strike(explorer.chosen, {triangle, weights, ...placeOf(body, {triangle, weights})});
    return new Promise(resolve => {
      explorer.sound.meter.port.addEventListener("message", ({data: {peak}}) => peak > least && resolve(true));
      setTimeout(() => resolve(false), 4000);
    });
  }, limit);
  return sounds && await page.locator("#error").isHidden();
};

for (const kind of made?.split(",") ?? []) await page.locator(`#make-${kind}`).click();
const silent = [], moved = [];
const bodies = await page.evaluate(() => window.idiophone.bodies.length);
for (let body = 0; body < bodies; ++body) {
  await page.evaluate(index => window.idiophone.explorer.choose(index), body);
  for (const control of await page.locator("#panel input[type=range]:visible").all()) {
    const {id, min, max, value} = await control.evaluate(input => ({id: input.id, min: input.min, max: input.max, value: input.value}));
    if (body > 0 && ["speed", "mass", "hardness", "volume"].includes(id)) continue;  // they do not belong to a body
    if (id.startsWith("drop-")) continue;  // no part of a blow
    moved.push(id);
    for (const to of [min, max]) {
      await control.fill(to);
      if (id.startsWith("made-")) await page.waitForTimeout(100);  // until the body is made
      if (!await heard()) silent.push(`${id} at ${to}`);
    }
    await control.fill(value);
  }
  const levels = await page.locator("#model:visible option").count();
  for (let level = levels - 1; level >= 0; --level) {
    moved.push("model");
    await page.locator("#model").selectOption({index: level});
    if (!await heard()) silent.push(`level ${level}`);
  }
}

await page.locator("#clipping").waitFor({state: "hidden"});
await page.locator("#volume").fill("40");
await page.locator("#speed").fill("1");
const clipped = await heard(1) && await page.locator("#clipping").waitFor({timeout: 4000}).then(() => true, () => false);
const said = complaints.slice();

await page.evaluate(() => window.idiophone.explorer.sound.send({strike: {body: 0, level: null, start: 0, force: null}}));
const ended = await page.locator("#error").waitFor({timeout: 4000}).then(() => page.locator("#error").textContent(), () => "");
const again = await heard();

/// Energy above 11 kHz of a blow on the first body: as it is, and after it was small while the sound began.
const regrown = await page.evaluate(async () => {
  const rate = 44100, body = window.idiophone.bodies[0], triangle = 2, weights = [0.3, 0.3, 0.4];
  Object.assign(body, {size: 1, friction: 1, level: null});
  const blow = blowOn(0, {triangle, weights, ...placeOf(body, {triangle, weights})}, {mass: 0.001, hardness: 1e9, speed: 1}, rate);
  const energy = async size => {
    const context = new OfflineAudioContext(body.channels.length, 8192, rate), analyser = new AnalyserNode(context, {fftSize: 8192});
    body.size = size;
    const node = await resonatorsIn(context, []);
    node.connect(analyser).connect(context.destination);
    body.size = 1;
    context.suspend(0).then(async () => {
      node.port.postMessage({tune: {body: 0, ...tuningOf(body)}, strike: {...blow, start: 0}});
      await new Promise(done => setTimeout(done, 200));  // for the message
      context.resume();
    });
    await context.startRendering();
    const levels = new Float32Array(4096);
    analyser.getFloatFrequencyData(levels);
    return levels.reduce((sum, level, bin) => sum + (bin * rate / 8192 > 11000 ? 10 ** (level / 10) : 0), 0);
  };
  return {fresh: await energy(1), grown: await energy(0.5)};
});
await browser.close();
console.log(JSON.stringify({complaints: said, first, clicked, moved, silent, clipped, ended, again, regrown}));
