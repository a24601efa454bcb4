// node large.mjs PAGE GIVEN: opens the Sonic Explorer in Chromium without a window, renders blows on its first body, each alone; then the
// last one on a longer body, and the first one by JavaScript; measures how long a second of the last one takes, s; and strikes
// so hard that the page doubts the pitch. Prints what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, given] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 1000, 700);
const isCompiled = await page.evaluate(() => compiledBytes !== null);
const heard = isCompiled && await page.evaluate(async ({blows, size, duration, rate}) => {
  const [body] = window.idiophone.bodies, {renderOffline} = window.idiophone, sounds = [];
  for (const blow of blows) sounds.push((await renderOffline([blow], duration, rate))[0]);
  const [javascript] = await renderOffline(blows.slice(0, 1), duration, rate, null);
  body.size = size;
  const [sized] = await renderOffline(blows.slice(-1), duration, rate);
  body.size = 1;

  const {origin, direction, hammer} = blows.at(-1), block = 128;
  const modes = new CompiledModes(compiledCode(compiledBytes), tuningOf(body), rate, body.stretching);
  modes.strike({start: 0, ...blowOn(0, hit(body, origin, unit(direction)), hammer, rate)});
  let load = Infinity;  // in a time in which hardly anybody interrupts
  for (let first = 0; first < rate; first += 4 * block) {
    const begin = performance.now();
    for (let piece = 0; piece < 4; ++piece) modes.render(first + piece * block, block);
    load = Math.min(load, (performance.now() - begin) / 1000 / (4 * block / rate));
  }
  return {sounds, javascript, sized, load};
}, JSON.parse(given));

const told = isCompiled && await (async () => {
  await page.locator("#room").press("Enter");  // browsers allow sound only after that
  await page.waitForFunction(() => window.idiophone.explorer.strikes === 1);
  await page.evaluate(({blows}) => {
    const {origin, direction, hammer} = blows.at(-1), {explorer, bodies: [body]} = window.idiophone;
    const blow = blowOn(0, hit(body, origin, unit(direction)), {...hammer, speed: 1e4}, 48000);
    explorer.sound.send({strike: blow});
  }, JSON.parse(given));
  await page.locator("#error").waitFor();
  return page.locator("#error").textContent();
})();
await browser.close();
console.log(JSON.stringify({complaints, heard, told}));
