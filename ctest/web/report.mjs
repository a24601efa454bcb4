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
    facts: rows("facts").length,
    deck: document.getElementById("deck").textContent,
    loudest: step * values.indexOf(Math.max(...values)),
    plots: document.querySelectorAll("#plots canvas").length,
    players: document.querySelectorAll("audio").length,
    frames: report.view?.times.length ?? 0,
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

// The last impact: its partials, and its part of the sound.
let last = null;
if (seen.impactsShown) {
  await page.locator("#impacts tr").last().click();
  last = await page.evaluate(() => ({
    from: window.idiophone.report.spectra.time.low,
    note: document.getElementById("partials-note").textContent,
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
await page.setViewportSize({width: 390, height: 760});  // a phone
const narrow = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
await browser.close();
console.log(JSON.stringify({complaints, ...seen, audio, zoomed, last, swapped, narrow}));
