// node report.mjs PAGE SCREENSHOT: opens a report in Chromium without a window, uses what a user can use, and prints what
// happened as JSON.
import {open} from "./browser.mjs";

const [page_file, screenshot] = process.argv.slice(2);

const {browser, page, complaints} = await open(page_file, 1200, 900, ["--autoplay-policy=no-user-gesture-required"]);
await page.waitForFunction(() => window.idiophone?.report.spectra.drawn >= 1);

const seen = await page.evaluate(() => {
  const {report, results} = window.idiophone;
  const rows = id => [...document.querySelectorAll(`#${id} tr`)].slice(1).map(row => [...row.children].map(cell => cell.textContent));
  const {values, step} = (() => {  // the loudest bin of the spectrum
    const {samples, rate} = results[0].channels[0], size = 2 ** Math.ceil(Math.log2(samples.length));
    return {values: levels(samples, 0, samples.length, size), step: rate / size};
  })();
  return {
    partials: rows("partials"),
    pairs: rows("pairs"),
    impacts: rows("impacts"),
    impactsShown: !document.getElementById("impacts-section").hidden,
    highest: report.spectra.frequency.high,
    accuracy: rows("accuracy"),
    facts: [...document.querySelectorAll("#facts tr")].map(row => [...row.children].map(cell => cell.textContent)),
    modes: [...document.querySelectorAll("#modes figcaption")].map(caption => caption.textContent),
    modesNote: document.getElementById("modes-note").textContent,
    partialsNote: document.getElementById("partials-note").textContent,
    deck: document.getElementById("deck").textContent,
    loudest: step * values.indexOf(Math.max(...values)),
    plots: document.querySelectorAll("#plots canvas").length,
    players: document.querySelectorAll("audio").length,
    frames: report.motion.view?.times.length ?? 0,
  };
});
const audio = await page.evaluate(() => Promise.all([...document.querySelectorAll("audio")].map(player =>
  player.duration || new Promise(resolve => player.onloadedmetadata = () => resolve(player.duration)))));

// Zoom into the spectrogram, and back.
await page.locator("#spectrogram").scrollIntoViewIfNeeded();
const box = await page.locator("#spectrogram").boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
const before = await page.evaluate(() => window.idiophone.report.spectra.drawn);
await page.mouse.wheel(0, -400);
await page.waitForFunction(count => window.idiophone.report.spectra.drawn > count, before);
const zoomed = await page.evaluate(() => {
  const {time} = window.idiophone.report.spectra;
  return (time.high - time.low) / (time.bounds[1] - time.bounds[0]);
});
await page.locator("#whole").click();

// The same by keys.
await page.locator("#spectrogram").press("+");
await page.locator("#spectrogram").press("ArrowRight");
const byKeys = await page.evaluate(() => {
  const {time} = window.idiophone.report.spectra;
  return {size: (time.high - time.low) / (time.bounds[1] - time.bounds[0]), from: time.low / time.bounds[1]};
});
await page.locator("#spectrogram").press("0");

// What only a picture of the energy shows: each of some clicks that are shorter than a pixel; and no click at the end.
const pictures = await page.evaluate(() => {
  const rate = 8000, samples = new Float32Array(60 * rate), columns = 100;
  const places = [...Array(20).keys()].map(n => Math.round((2.91 * n + 1.07) * rate));
  for (const place of places) samples[place] = 1;
  const time = {low: 0, high: 60}, frequency = {low: 0, high: rate / 2};
  const clicks = energyPicture({samples, rate}, time, frequency, columns, 50);
  const atClicks = places.map(place => clicks.values[25 * columns + Math.floor(place / rate / 60 * columns)] - clicks.loudest);
  const tone = Float32Array.from({length: rate}, (_, n) => Math.sin(2 * Math.PI * 1234 * n / rate));
  const cut = energyPicture({samples: tone, rate}, {low: 0, high: 1}, frequency, 100, 50), far = 40 * 100;
  return {quietestClick: Math.min(...atClicks), smear: cut.values[far + 99] - cut.values[far + 50],
          level: Math.max(...cut.values)};
});

const images = await page.evaluate(() => Promise.all([...document.querySelectorAll("#modes img")].map(async image => {
  image.loading = "eager";
  await image.decode();
  return image.naturalWidth;
})));

// The last impact: its partials, and its part of the sound.
let last = null;
if (seen.impactsShown) {
  await page.locator("#impacts button").last().press("Enter");
  last = await page.evaluate(() => ({
    from: window.idiophone.report.spectra.time.low,
    note: document.getElementById("partials-note").textContent,
    pressed: document.querySelectorAll("#impacts button[aria-pressed=true]").length,
    frequencies: [...document.querySelectorAll("#partials tr")].slice(1).map(row => Number(row.firstChild.textContent)),
  }));
  await page.locator("#whole").click();
}

let swapped = "";
if (await page.locator("#switch").isVisible()) {
  await page.locator("#play").click();
  await page.locator("#swap").click();
  swapped = await page.locator("#swap").textContent();
  await page.locator("#play").click();
  await page.locator("#results button").nth(1).click();
  await page.locator("#results button").nth(0).click();
}
if (seen.frames > 0) {
  await page.locator("#frame").press("ArrowRight");
}
await page.waitForTimeout(300);
await page.screenshot({path: screenshot, fullPage: true});
const corner = () => page.evaluate(() => {
  const pen = new OffscreenCanvas(1, 1).getContext("2d", {willReadFrequently: true});
  pen.drawImage(document.getElementById("spectrum"), 0, 0);
  return [...pen.getImageData(0, 0, 1, 1).data];
});
const light = await corner();
const pictureOf = () => page.evaluate(() => window.idiophone.report.spectra.drawn);
const inLight = await pictureOf();
await page.emulateMedia({colorScheme: "dark"});
await page.waitForFunction(count => window.idiophone.report.spectra.drawn > count, inLight);
const dark = await corner();
await page.emulateMedia({colorScheme: "light"});
await page.setViewportSize({width: 390, height: 760});  // a phone
const scrolling = await page.evaluate(() => [...document.querySelectorAll("canvas")].map(canvas => getComputedStyle(canvas).touchAction));
const unlabelled = await page.evaluate(() => document.querySelectorAll("canvas:not([aria-label]), img:not([alt]), audio:not([aria-label])").length);
const narrow = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
await browser.close();
console.log(JSON.stringify({complaints, ...seen, audio, zoomed, byKeys, pictures, images, last, swapped, light, dark, scrolling,
                            unlabelled, narrow}));
