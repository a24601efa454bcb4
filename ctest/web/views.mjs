// node views.mjs PAGE: opens a Sonic Explorer with proxies in Chromium without a window, looks at the views of each level and
// of masses, springs and surfaces, strikes by a click on a view, and watches the waveform. Prints what it saw as JSON.
import {openExplorer} from "./browser.mjs";

const {browser, page, complaints} = await openExplorer(process.argv[2], 1000, 800);

/// Pixels of each third of the views that are not empty or text, and their mean colour.
const look = () => page.evaluate(() => {
  const canvas = document.getElementById("views-canvas"), {width, height} = canvas;
  const {data} = canvas.getContext("2d").getImageData(0, 14, width, height - 14);
  const count = [0, 0, 0], sum = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 50) continue;
    ++count[Math.min(2, Math.floor(3 * (i / 4 % width) / width))];
    for (let part = 0; part < 3; ++part) sum[part] += data[i + part];
  }
  return {count, colour: sum.map(part => part / count.reduce((a, b) => a + b))};
});

const levels = [];
for (const level of ["", "0", "1"]) {
  await page.locator("#model").selectOption(level);
  levels.push({legend: await page.locator("#views-legend").textContent(), colour: (await look()).colour});
}
await page.locator("#model").selectOption("0");
const drawn = {};
for (const what of ["masses", "surface", "springs"]) {
  await page.locator("#views-show").selectOption(what);
  drawn[what] = (await look()).count;
}

const waveform = () => page.evaluate(() => {
  const canvas = document.getElementById("waveform"), {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let green = 0, red = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 128 && data[i + 1] > data[i] + 40) ++green;
    if (data[i + 3] > 128 && data[i] > data[i + 1] + 40) ++red;
  }
  const {explorer} = window.idiophone, rate = explorer.sound.analyser?.context.sampleRate;
  return {green, red, seconds: explorer.waveform.ranges.length / 2 * 512 / rate};
});
const before = (await waveform()).green;
const views = await page.locator("#views-canvas").boundingBox();
await page.locator("#views-canvas").click({position: {x: views.width / 6 + 3, y: views.height / 2 + 2}});
const struck = page.waitForFunction(() => window.idiophone.explorer.strikes > 0, null, {timeout: 10000});
await struck.catch(() => null);
const said = await page.locator("#blow").textContent();
await page.waitForTimeout(600);
const {green, red} = await waveform();
await page.waitForFunction(() => {
  const {ranges, whole} = window.idiophone.explorer.waveform;
  return ranges.length === whole;
}, null, {timeout: 20000}).catch(() => null);
await page.waitForTimeout(500);
console.log(JSON.stringify({complaints, levels, drawn, said, waveform: {before, green, red, seconds: (await waveform()).seconds}}));
await browser.close();
