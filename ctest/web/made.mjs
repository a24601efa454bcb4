// node made.mjs PAGE RECIPES SCREENSHOT: opens a Sonic Explorer without maps in Chromium without a window; makes bodies by
// recipes, {NAME: recipe, ...}; makes a membrane by its button, draws a square, a circle and an eight as its rim, and strikes it.
// Prints what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, recipes, screenshot] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 800, 1100);
const begins = await page.evaluate(() => window.idiophone.bodies.map(({name}) => name));

const made = await page.evaluate(named => Object.entries(named).map(([name, recipe]) => {
  const {frequency, materialDecay, radiationDecay, channels: [{delay, pressure}]} = madeBody(name, recipe);
  return {name, frequency: [...frequency], materialDecay: [...materialDecay], radiationDecay: [...radiationDecay], delay,
          pressure: [...pressure]};
}), JSON.parse(recipes));

await page.locator("#make-membrane").click();
const canvas = await page.locator("#outline").boundingBox();

/// Draws a line; numbers from -1 to 1 about the middle of the canvas.
const draw = async points => {
  const at = ([x, y]) => [canvas.x + canvas.width / 2 + 0.45 * canvas.height * x, canvas.y + canvas.height / 2 - 0.45 * canvas.height * y];
  await page.mouse.move(...at(points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...at(point));
  await page.mouse.up();
  return page.evaluate(() => {
    const {explorer, bodies} = window.idiophone;
    return {frequency: [...bodies[explorer.chosen].frequency.slice(0, 6)], error: element("error").hidden ? "" : element("error").textContent};
  });
};
const along = (from, to) => Array.from({length: 12}, (_, n) => [0, 1].map(axis => from[axis] + n / 12 * (to[axis] - from[axis])));
const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const round = shape => Array.from({length: 60}, (_, n) => shape(Math.PI * n / 30));
const square = await draw(corners.flatMap((corner, i) => along(corner, corners[(i + 1) % 4])));
const eight = await draw(round(angle => [Math.sin(angle), Math.sin(2 * angle)]));
const circle = await draw(round(angle => [Math.cos(angle), -Math.sin(angle)]));

const heard = await page.evaluate(async () => {
  const {explorer, bodies} = window.idiophone, body = bodies[explorer.chosen], rate = 44100;
  const blow = {time: 0, body: explorer.chosen, origin: [...body.recipe.position.slice(0, 2), 1], direction: [0, 0, -1],
                hammer: {mass: 0.01, hardness: 1e6, speed: 1}};
  const [sound] = await window.idiophone.renderOffline([blow], 0.5, rate);
  const at = hertz => Math.hypot(...[Math.cos, Math.sin].map(part =>
    sound.reduce((sum, value, i) => sum + value * part(2 * Math.PI * hertz * i / rate), 0)));
  return {first: at(body.frequency[0]), between: at(0.7 * body.frequency[0])};
});
await page.screenshot({path: screenshot});
await browser.close();
console.log(JSON.stringify({complaints, begins, made, square, eight, circle, heard}));
