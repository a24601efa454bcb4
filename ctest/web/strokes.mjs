// node strokes.mjs PAGE TOOL SCREENSHOT: opens the Sonic Explorer in Chromium without a window; computes the force of a tool at
// two constant speeds and at rest; bows the first body, if the page has WebAssembly; scrapes, rolls over and bows the second body
// with the pointer, and drags beside it. Prints what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, tool, screenshot] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 800, 500);

const forces = await page.evaluate(given => {
  const profile = profileOf(given.roughness, given.size), force = new StrokeForce({...given, profile}, given.rate);
  const during = (speed, duration) => {
    force.wanted = {load: given.load, speed};
    force.next(given.rate / 10);  // until it has settled
    return [...force.next(duration * given.rate)];
  };
  return {slow: during(given.speeds[0], 2), fast: during(given.speeds[1], 2), rest: during(0, 0.1)};
}, JSON.parse(tool));

const bowed = await page.evaluate(({rate, bow}) => {  // for a second at a seventh of the length, and a second more
  if (!compiledBytes) return null;
  const [string] = window.idiophone.bodies, {low, high} = boundsOf([string]);
  const modes = new CompiledModes(compiledCode(compiledBytes), tuningOf(string), rate);
  const over = [low[0] + (high[0] - low[0]) / 7, (low[1] + high[1]) / 2, 1], sound = [];
  const participation = participationOf(string, hit(string, over, [0, 0, -1]), [0, 0, 1]);
  const listen = end => {
    for (let block; sound.length < end; sound.push(...block)) [block] = modes.render(sound.length, 128);
  };
  modes.putBow(1, participation);
  modes.leadBow(1, bow, participation);
  listen(rate);
  modes.liftBow(1);
  listen(2 * rate);
  return {frequency: string.frequency[0], decay: decayOf(string, 0), sound};
}, JSON.parse(tool));

/// Drags the pointer over the second body or beside all; what is heard on the way, and by how much the room turns.
const room = await page.locator("#room").boundingBox();
const drag = async places => {
  const azimuth = () => page.evaluate(() => window.idiophone.explorer.view.azimuth), before = await azimuth();
  await page.evaluate(() => {
    const {sound} = window.idiophone.explorer;
    window.loudest = 0;
    window.listening ??= sound.start().then(() => sound.meter.port.addEventListener("message", ({data: {peak}}) => window.loudest = Math.max(window.loudest, peak)));
    return window.listening;
  });
  await page.mouse.move(room.x + places[0][0], room.y + places[0][1]);
  await page.mouse.down();
  for (let step = 1; step <= 30; ++step) {
    const at = [0, 1].map(axis => places[0][axis] + step / 30 * (places[1][axis] - places[0][axis]));
    await page.mouse.move(room.x + at[0], room.y + at[1]);
    await page.waitForTimeout(15);
  }
  const told = await page.locator("#blow").textContent();
  await page.mouse.up();
  await page.waitForTimeout(300);
  return {loudest: await page.evaluate(() => window.loudest), turned: await azimuth() - before, told,
          strokes: await page.evaluate(() => window.idiophone.explorer.room.tool.strokes.size)};
};
const way = await page.evaluate(() => {  // across the second body, from a third to two thirds of it
  const {view} = window.idiophone.explorer, {low, high} = boundsOf([view.bodies[1]]);
  const at = share => [0, 1, 2].map(axis => low[axis] + share * (high[axis] - low[axis]));
  const seen = view.onScreen(Float32Array.from([...at(0.3), ...at(0.7)]));
  return [[seen[0], seen[1]], [seen[3], seen[4]]];
});
const loads = await page.evaluate(() => [["mouse", 0.5], ["pen", 0.25], ["touch", 1], ["touch", 0]].map(
  pressing => window.idiophone.explorer.room.tool.loadOf(...pressing)));
const drags = {};
await page.locator("#pointer").selectOption("scrape");
drags.scraped = await drag(way);
await page.screenshot({path: screenshot});
await page.locator("#pointer").selectOption("roll");
drags.rolled = await drag(way);
if (bowed) {
  await page.locator("#pointer").selectOption("bow");
  drags.bowed = await drag(way);
}
drags.beside = await drag([[5, 5], [60, 5]]);
await browser.close();
console.log(JSON.stringify({complaints, forces, bowed, loads, drags}));
