// node abx.mjs PAGE: opens a listening test in Chromium without a window; answers all trials rightly with the keyboard, then all
// but two with the mouse. Prints what happened as JSON.
import {open} from "./browser.mjs";

const {browser, page, complaints} = await open(process.argv[2], 390, 760);

const sounds = await page.evaluate(() => window.idiophone.abx.player.sounds.map(
  ({rate, channels}) => ({rate, channels: channels.map(samples => [...samples])})));
const chances = await page.evaluate(() => [[16, 16], [12, 16], [0, 16], [5, 7]].map(pair => window.idiophone.chanceByGuessing(...pair)));
const tosses = await page.evaluate(() => Array.from({length: 400}, () => {
  window.idiophone.abx.toss();
  return window.idiophone.abx.x;
}));
const early = await page.locator("#answer-a").isDisabled();  // before X was heard
const names = await page.locator("#names").textContent();

const x = () => page.evaluate(() => window.idiophone.abx.x);
const play = async () => {
  await page.keyboard.press("x");
  await page.waitForFunction(() => !document.getElementById("answer-a").disabled);
};
await page.evaluate(() => {
  const {abx} = window.idiophone, mark = abx.mark;
  window.marked = [];
  abx.mark = name => window.marked.push(name) && mark.call(abx, name);
});
await page.keyboard.press("a");
await page.keyboard.press("b");
await page.waitForFunction(() => ["a", "b", ""].every(name => window.marked.includes(name)));
const trials = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).trials);
let told = "";  // while the test goes on
for (let trial = 0; trial < trials; ++trial) {
  told += await page.locator("#result").textContent();
  await play();
  await page.keyboard.press(await x() === 0 ? "1" : "2");
}
const all = await page.locator("#result").textContent();
const over = await page.locator("#answer-a").isDisabled();
await page.locator("#again").click();
for (let trial = 0; trial < trials; ++trial) {
  await play();
  const right = trial >= 2;
  await page.locator(await x() === 0 === right ? "#answer-a" : "#answer-b").click();
}
const most = await page.locator("#result").textContent();
const narrow = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
await browser.close();
console.log(JSON.stringify({complaints, sounds, chances, tosses, early, names, told, all, over, most, narrow}));
