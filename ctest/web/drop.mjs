// node drop.mjs PAGE GIVEN SCREENSHOT: opens the Sonic Explorer in Chromium without a window; renders the blows that given contacts
// become, and the force of a contact that slides; lets the bodies fall in a heap, strikes one where it lies, and puts all back. Prints
// what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, given, screenshot] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 1000, 900);
const isThere = await page.locator("#drop").isVisible();
const isCompiled = await page.evaluate(() => compiledBytes !== null);

const sound = isCompiled && await page.evaluate(async ({surfaces, steps, step, rate, seconds}) => {
  const {bodies} = window.idiophone, rigid = bodies.map(body => new RigidBody(body, body.mass));
  const sounds = new ContactSounds(compiledCode(compiledBytes), surfaces, rate);
  const forces = steps.flatMap((events, n) => sounds.step(events, Math.round(n * step * rate), step));
  sounds.end();
  return renderStrikes(forces.flatMap(force => strikesOf(force, rigid)), seconds, rate);
}, JSON.parse(given));

const slid = isCompiled && await page.evaluate(({surfaces, slide, step, rate}) => {
  const sounds = new ContactSounds(compiledCode(compiledBytes), surfaces, rate), newtons = new Float64Array(3 * rate);
  for (let n = 0; n * step < 2.9; ++n) {
    for (const {start, force: {mean}} of sounds.step([slide], Math.round(n * step * rate), step)) {
      mean.forEach((value, i) => newtons[start + i] += value);
    }
  }
  return [...newtons.subarray(0.5 * rate, 2.5 * rate)];
}, JSON.parse(given));

/// Of each body: the height of its lowest vertex over the ground, m, and whether it has moved.
const lying = () => page.evaluate(() => {
  const {view} = window.idiophone.explorer;
  return view.bodies.map((body, index) => {
    const {low} = boundsOf([{vertices: movedVertices(body, view.poses[index])}]);
    return {height: low[2] - view.groundHeight(), moved: view.poses[index] !== undefined};
  });
});

let fallen = null;
if (isCompiled) {
  await page.evaluate(async () => {
    const {explorer} = window.idiophone;
    await explorer.sound.start();
    window.loudest = 0;
    let random = 1;  // always the same drop
    Math.random = () => (random = random * 16807 % 2147483647) / 2147483647;
    explorer.sound.meter.port.addEventListener("message", ({data: {peak}}) => window.loudest = Math.max(window.loudest, peak));
  });
  await page.locator("#drop-what").selectOption("heap");
  await page.locator("#drop-start").click();
  await page.waitForFunction(() => window.idiophone.explorer.dropping.drop);
  await page.waitForFunction(() => !window.idiophone.explorer.dropping.drop, null, {timeout: 120000});
  await page.waitForTimeout(300);
  fallen = {loudest: await page.evaluate(() => window.loudest), lying: await lying(), ended: await page.locator("#error").isVisible()};
  await page.screenshot({path: screenshot});
  const room = await page.locator("#room").boundingBox();
  const place = await page.evaluate(() => {  // of the first body's middle on the screen
    const {view} = window.idiophone.explorer, {low, high} = boundsOf([view.bodies[0]]);
    const vertices = new Float32Array(low.map((at, axis) => 0.5 * (at + high[axis])));
    return [...view.onScreen(movedVertices({vertices}, view.poses[0]))];
  });
  fallen.missed = await page.evaluate(at => {  // by the point that is picked there, pixels
    const {view} = window.idiophone.explorer, {body, point} = pick(view, at[0], at[1]);
    const [x, y] = view.onScreen(movedVertices({vertices: new Float32Array(point.place)}, view.poses[body]));
    return Math.hypot(x - at[0], y - at[1]);
  }, place);
  await page.mouse.click(room.x + place[0], room.y + place[1]);
  await page.waitForFunction(() => window.idiophone.explorer.strikes === 1);
  fallen.struck = await page.locator("#blow").textContent();
  await page.locator("#drop-back").click();
  fallen.back = (await lying()).map(({moved}) => moved);
}
await browser.close();
console.log(JSON.stringify({complaints, isThere, isCompiled, sound, slid, fallen}));
